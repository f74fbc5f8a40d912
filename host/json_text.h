#pragma once
// JSON as text.

#include <nlohmann/json.hpp>

#include <string>

namespace eikonal {

/// A JSON value as ASCII. Bytes that are no UTF-8, as in some names of files, become U+FFFD, and control characters are escaped, so that
/// it is safe to print. indent: spaces for each level; -1: all on one line.
template <class Json> std::string jsonText(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', true, Json::error_handler_t::replace);
}

}  // namespace eikonal
