#pragma once
// What a user wishes of a render: an error or a time.

#include <string>

namespace eikonal {

struct Wish {
    enum class Kind { error, seconds } kind = Kind::seconds;
    double value = 0;                      ///< seconds, or an error: a root of relMSE
    std::string text() const;              ///< "30 s", "2 %"
    bool operator==(const Wish&) const = default;
};

}  // namespace eikonal
