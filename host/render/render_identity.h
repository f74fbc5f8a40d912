#pragma once
// What an image's bits depend on, so that a film is only continued by the render that began it.

#include "film/film.h"
#include "render/session.h"

#include <string>
#include <utility>
#include <vector>

namespace eikonal {

struct RenderIdentity {
    using Values = std::vector<std::pair<std::string, std::string>>;   ///< name and value
    Values settings;        ///< of the program, the scene and the command line
    Values part;            ///< the pixels and samples that are rendered of the image
    Values tables;          ///< hashes of the packed scene, by the kind of thing
    Values files;           ///< hashes of the contents of the scene's files; for messages only, since some changes have no effect
    std::string device;     ///< devices of one kind give the same bits
    int samples = 0;        ///< per pixel, that the render was laid out for (Session::layOutFor); more may be taken
};

/// Of a session that is packed, and keeps `film`.
RenderIdentity identityOf(const Session& session, const SessionOptions& options, const Film& film);

std::string toJson(const RenderIdentity& identity);
/// Throws Error (ExitCode::scene), "name: ...", for a text that toJson did not make.
RenderIdentity identityFromJson(const std::string& text, const std::string& name);

/// Each difference that matters, as a sentence with both values; empty: none. `here` is compared with `there`, which is called `name`.
std::vector<std::string> differences(const RenderIdentity& here, const RenderIdentity& there, const std::string& name);

/// The same for parts of an image, which may have other pixels and samples, but must be laid out for as many samples.
std::vector<std::string> partDifferences(const RenderIdentity& here, const RenderIdentity& there, const std::string& name);

}  // namespace eikonal
