#pragma once
// The secret in the address of a page that is served.

#include <string>

namespace eikonal {

/// 128 random bits of the system as 32 hexadecimal digits. Throws a std::runtime_error if it has none.
std::string randomToken();
/// Whether both are the same, in a time that does not depend on where they differ.
bool isSameToken(const std::string& a, const std::string& b);

}  // namespace eikonal
