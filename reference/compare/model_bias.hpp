// Bias and relative standard deviation of a model over many comparisons, as validation guides of
// fire models tabulate them (McGrattan & Toman, "Quantifying the predictive uncertainty of complex
// numerical models", Metrologia 48, 173 (2011); FDS Validation Guide, NIST SP 1018-3, chapter 4).
//
// Model M_i and reference E_i of the same quantity, whose errors are relative:
//   M | truth ~ N(delta truth, (sigma_M delta truth)^2),  E ~ N(truth, (sigma_E truth)^2)
// With y_i = ln(M_i/E_i), mean m and unbiased variance u^2:
//   sigma_M^2 = u^2 - sigma_E^2,   delta = exp(m + (sigma_M^2 - sigma_E^2)/2)
#pragma once

#include <cstddef>
#include <span>

namespace crossgrain::compare {

struct ModelComparison {
    double model = 0;
    double reference = 0;                 ///< not 0, of the same sign as `model`
    double reference_relative_error = 0;  ///< standard error of the reference over its size, >= 0
    double model_relative_error = 0;      ///< statistical, of the model's value; >= 0
};

struct ModelBias {
    double bias = 1;                ///< delta; 1: none
    double relative_deviation = 0;  ///< sigma_M, statistical errors of the model taken off; 0 if
                                    ///< references and statistics explain all of the scatter
    double bias_low = 0, bias_high = 0;   ///< 95 %, by t
    double reference_relative_error = 0;  ///< sigma_E: root of the mean square of those given
    std::size_t comparisons = 0;
};

/// Throws std::invalid_argument for fewer than two comparisons, or a pair of which one is 0, not
/// finite or of the other sign than its partner.
[[nodiscard]] ModelBias model_bias(std::span<const ModelComparison> comparisons);

}  // namespace crossgrain::compare
