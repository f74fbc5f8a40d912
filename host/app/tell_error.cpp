#include "app/tell_error.h"

#include "error.h"
#include "messages.h"

#include <new>

namespace eikonal {

static int fail(ExitCode code, const std::string& message, const std::string& scene) {
    tell(LogLevel::error, scene.empty() ? message : message + "\n" + scene + " was not rendered");
    return static_cast<int>(code);
}

int tellError(const std::string& scene) {
    try {
        throw;
    } catch (const Error& error) {
        /* Those of a scene or a file begin with its name */
        const std::string what = error.what();
        const auto* ofScene = dynamic_cast<const SceneError*>(&error);
        const bool beginsWithPlace =
            error.code() == ExitCode::scene && ((ofScene && ofScene->hasPlace) || what.find(": ") < what.find(' '));
        return fail(error.code(), (beginsWithPlace ? "" : "error: ") + what, scene);
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::scene,
                    "error: not enough memory; `eikonal info` tells how much a render takes. A mesh that ObjectInstance places several "
                    "times is stored once; --pixelbounds renders a part of the image", scene);
    } catch (const std::exception& error) { return fail(ExitCode::scene, std::string("error: ") + error.what(), scene); }
}

}  // namespace eikonal
