#pragma once
// What a film file says about the image that is to be made of it.

#include "film/noise.h"
#include "image/film_image.h"
#include "render/options.h"

#include <string>

namespace eikonal {

struct StoredMetadata {
    Metadata metadata;    ///< without what follows from the film
    Aovs aovs;            ///< channels to write
    ErrorMetric metric = ErrorMetric::relmseRoot;
};

std::string toJson(const StoredMetadata& stored);
/// Throws Error (ExitCode::scene), "name: ...", for a text that toJson did not make.
StoredMetadata storedMetadata(const std::string& text, const std::string& name);

}  // namespace eikonal
