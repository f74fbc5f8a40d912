#pragma once
// Decoded images that several renders of a process share.

#include "image/file_stamp.h"
#include "image/image_data.h"
#include "scene/textures.h"

#include <memory>
#include <string>

namespace eikonal {

/// A render begins that others of this process precede or follow: from now on, images are kept when they are decoded. Those that the
/// render before has not used are dropped. Without a call, none is kept.
void keepImages();

/// The image of a file as it was decoded before; null: it was not, or the file has changed since. Thread-safe.
std::shared_ptr<const ImageData> keptImage(const ImageFile& file);

/// Keeps an image, unless all that are kept would take more than a quarter of the memory that is available. stamp: from before the file was
/// read. Thread-safe.
void keepImage(const ImageFile& file, const FileStamp& stamp, const std::shared_ptr<const ImageData>& image);

}  // namespace eikonal
