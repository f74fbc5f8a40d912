// The options of animations.

#include "app/frame_numbers.h"
#include "app/options/declare.h"
#include "app/options/shared_options.h"

namespace eikonal {

void addFrames(CLI::App* app, Options& o) {
    const std::string group = framesGroup;
    value(app, "--frames", o.frames, "LIST", "Render these frames, like 1-10:2,20: # in the names of the scene and of -o is their number",
          parseFrames)
        ->group(group);
    value(app, "--fps", o.scene.fps, "N",
          "The frames of one scene that moves: frame f is seen when f / N units of the scene's time have passed", number(0))
        ->group(group);
    value(app, "--shutter", o.scene.shutter, "X",
          "With --fps: the share of a frame that the shutter is open; 0.5 is 180 degrees (default: as long as in the scene)", number(0))
        ->group(group);
    value(app, "--turntable", o.scene.turntable, "N",
          "The camera goes round an OBJ in N frames; all are rendered, unless --frames selects some", integer(1, mostFrames))
        ->group(group);
}

}  // namespace eikonal
