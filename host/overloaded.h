#pragma once

namespace eikonal {

/// Combines lambdas into one function object for std::visit: Overloaded{[](const A&) { ... }, [](const B&) { ... }}.
template <class... F> struct Overloaded : F... { using F::operator()...; };

}  // namespace eikonal
