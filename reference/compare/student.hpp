// Quantiles of Student's t distribution and degrees of freedom of a difference.
#pragma once

namespace crossgrain::compare {

/// t with P(T <= t) = probability for `degrees_of_freedom` > 0 (need not be whole; infinite gives
/// the normal distribution). Throws std::domain_error unless 0 < probability < 1.
[[nodiscard]] double student_quantile(double probability, double degrees_of_freedom);

/// Effective degrees of freedom of the difference of two means with standard errors s1, s2 of dof1,
/// dof2 degrees of freedom (Welch, Biometrika 34, 28 (1947); Satterthwaite, Biometrics Bulletin 2,
/// 110 (1946)): (s1^2 + s2^2)^2/(s1^4/dof1 + s2^4/dof2). Infinite when both errors are 0.
[[nodiscard]] double welch_degrees_of_freedom(double s1, double dof1, double s2, double dof2);

}  // namespace crossgrain::compare
