#pragma once
// Options that several commands have.

#include "app/options.h"

#include <CLI/CLI.hpp>

namespace eikonal {

void addLogging(CLI::App* app, Options& o);
CLI::Option* addListDevices(CLI::App* app, Options& o);
/// Where and how kernels run.
void addDevice(CLI::App* app, Options& o);
/// What overrides the scene. takesOne: the command takes a single scene.
void addScene(CLI::App* app, Options& o, bool takesOne = true);
/// Which frames of an animation.
void addFrames(CLI::App* app, Options& o);
/// How files are encoded.
void addEncoding(CLI::App* app, OutputOptions& out);
/// -o, and that.
void addImageFiles(CLI::App* app, OutputOptions& out);
CLI::Option* addAov(CLI::App* app, OutputOptions& out);
void addTilesBy(CLI::App* app, OutputOptions& out);
CLI::Option* addCheckpointInterval(CLI::App* app, OutputOptions& out);

}  // namespace eikonal
