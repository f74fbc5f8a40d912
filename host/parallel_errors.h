#pragma once
// Many things at once, of which several may be wrong.

#include "error.h"

#include <tbb/parallel_for.h>

#include <cstddef>
#include <string>
#include <vector>

namespace eikonal {

/// Calls f(i) for 0 <= i < count, in parallel, and all of them whatever happens. Throws one Error (ExitCode::scene) that lists the Errors that
/// they threw, a line each, in the order of i.
template <class F> void forEachInParallel(std::size_t count, const F& f) {
    std::vector<std::string> errors(count);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        try {
            f(i);
        } catch (const Error& error) {
            errors[i] = error.what();
        }
    });
    std::string all;
    for (const std::string& error : errors)
        if (!error.empty()) all += (all.empty() ? "" : "\n") + error;
    if (!all.empty()) throw Error(ExitCode::scene, all);
}

}  // namespace eikonal
