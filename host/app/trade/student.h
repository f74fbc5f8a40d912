#pragma once
// Student's t distribution.

namespace eikonal {

/// The chance that |T| exceeds |t|, for `freedom` >= 1 degrees of freedom.
double studentTail(double t, int freedom);
/// The t that |T| exceeds with chance `tail`, in (0, 1); 0 for no degree of freedom.
double studentQuantile(int freedom, double tail = 0.05);

}  // namespace eikonal
