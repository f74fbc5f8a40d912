#pragma once
// Scenes of one implicit surface.

#include "stage.h"

#include <string>

namespace eikonal {

/// In a box from -2 to 2, so that scene space is object space over 4.
inline PackedScene sceneOf(const std::string& F) {
    return packText("WorldBegin Shape \"implicit\" \"string F\" \"" + F + "\" \"point3 bounds\" [-2 -2 -2  2 2 2]");
}

}  // namespace eikonal
