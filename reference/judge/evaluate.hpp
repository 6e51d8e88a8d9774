// Answers the questions of a case from its runs: verdicts, combined measurements, convergence and
// the certificate of equivalence. Computes no physics; everything comes from stored results.
#pragma once

#include "reference/compare/equivalence.hpp"
#include "reference/judge/case_runs.hpp"
#include "reference/published/published.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::judge {

/// A measurement of a code over all its replicas.
struct CodeMeasurement {
    std::string code, variant;
    std::size_t rung = 0;
    double dt = 0;
    compare::Combined combined;
};

/// Error of an observable against dt, for the report's convergence figure.
struct ConvergenceCurve {
    std::string code, variant, observable;
    std::vector<double> dt, mean_error, rms_error;
    double order = 0, order_error = 0, limit = 0, limit_error = 0;
    double order_degrees_of_freedom = 0;
};

/// How far two codes stayed together.
struct CertificatePair {
    std::string case_name, a, b;
    double contact_time = 0;
    double diameter = 0;
    std::map<std::string, double> max_dx;   ///< after 1, 10, 100, ... contact times
    std::vector<double> curve_t, curve_dx;  ///< time and max |dx| at every snapshot
    std::map<std::string, double> limits;   ///< of max_dx, where a check states one
    std::map<std::string, double> max_dh;   ///< lid height, by time window, e.g. "0-6"
    std::map<std::string, double> limits_dh;
    compare::Outcome outcome = compare::Outcome::undecided;
    bool expected = true;
    std::string reason;
};

/// A parity check's answer for one pair of codes, as an index into the verdicts.
struct ParityAnswer {
    const catalog::Check* check = nullptr;
    std::size_t verdict = 0;
};

struct Evaluation {
    std::vector<CodeMeasurement> measurements;
    std::vector<ConvergenceCurve> curves;
    std::vector<compare::Verdict> verdicts;
    std::vector<ParityAnswer> parity;
    std::vector<CertificatePair> certificate;
};

[[nodiscard]] Evaluation evaluate(const CaseRuns& runs,
                                  const published::PublishedValues& literature);

/// Appends what the case fits over its variants: measurements without a variant, slopes with that
/// at which they are taken.
void evaluate_fits(const CaseRuns& runs, Evaluation& evaluation);

/// Whether a parity check of the case looks at trajectories or at a window of a series.
[[nodiscard]] bool can_be_certified(const catalog::Case& the_case);
/// To be called after the parity checks.
void evaluate_certificate(const CaseRuns& runs, Evaluation& evaluation);

/// What a code measured in a variant, by its runs or by a fit over the variants of the case, which
/// has the same value in each; nothing if a run lacks it or the fit had too few points.
[[nodiscard]] std::optional<compare::Combined>
measured(const CaseRuns& runs, const Evaluation& evaluation, const std::string& code,
         std::size_t variant, const std::string& observable);
/// Whether the case fits the observable over its variants, so that it belongs to none of them.
[[nodiscard]] bool is_fitted(const catalog::Case& the_case, const std::string& observable);
/// A measurement as an operand of a comparison.
[[nodiscard]] compare::Operand operand_of(const compare::Combined& combined);

}  // namespace crossgrain::judge
