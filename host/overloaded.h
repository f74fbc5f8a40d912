#pragma once

namespace eikonal {

/// One function of several lambdas, for std::visit: Overloaded{[](const A&) { ... }, [](const B&) { ... }}.
template <class... F> struct Overloaded : F... { using F::operator()...; };

}  // namespace eikonal
