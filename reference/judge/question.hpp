// What a check asks of one code, or of a pair, in one place. Every check is operand, operand, rule:
//
//   one operand                    the other                               rule
//   measurement of a code          of another code, in another variant,    equivalence
//                                  another observable, published value
//   runs of a code                 runs of another code                    parity
//   measurements on a ladder of    closed form at every time step          equivalence, or
//   time steps                                                             convergence
//   measurements along a sweep     published trend                         trend
//
// A measurement is of the runs, or a fit over the variants of the case (evaluate_fits.cpp).
// Operands are read in operands.cpp; rules are in rules.cpp and rule_convergence.cpp; the loop over
// places, codes and what is absent is answer_check(), in answer_check.cpp.
#pragma once

#include "reference/judge/evaluate.hpp"

#include <span>

namespace crossgrain::judge {

struct Question {
    const CaseRuns& runs;
    const catalog::Check& check;
    const published::PublishedValues& literature;
    const Evaluation& evaluation;  ///< for its measurements
    std::string other;             ///< second code of a pair, or empty; the first: verdict.code
    std::vector<std::size_t> variants;  ///< one; two that are compared; or those of a sweep
    compare::Verdict verdict;
    std::optional<ConvergenceCurve> curve;  ///< of a judged order
};

/// Both operands at one place of a sequence.
struct Point {
    double at = 0;  ///< time step of a rung, or value of the key of a sweep
    compare::Combined measured;
    compare::Operand reference;  ///< unused for trends
    std::size_t replicas = 0;    ///< behind the number, the fewer of both
};

struct Operands {
    std::vector<Point> points;       ///< one, but on ladders and along sweeps; else nothing missing
    std::optional<Absence> missing;  ///< the first operand that is not there
};

/// All questions of a check, answered, in the order of the report: by variant, then by code.
[[nodiscard]] std::vector<Question> answer_check(const CaseRuns& runs, const catalog::Check& check,
                                                 const published::PublishedValues& literature,
                                                 const Evaluation& evaluation);

[[nodiscard]] Operands operands_of(const Question& question);

// The rules. Each writes its answer into the verdict; `points` as operands_of() gives them.

/// Equivalence within the limit, at the point that is farthest from its reference.
void judge_equivalence(Question& question, std::span<const Point> points);
/// Order of convergence in the time step, or limit for dt -> 0 (compare/convergence.hpp).
void judge_convergence(Question& question, std::span<const Point> points);
/// Whether the distance of two codes' runs is within round-off.
void judge_parity(Question& question, std::span<const Point> points);
/// Constant, increasing or decreasing along the sweep (compare/trend.hpp).
void judge_trend(Question& question, std::span<const Point> points);
/// Doubts pairs without any difference at a time at which round-off has grown between other codes:
/// both read the same output. `questions`: all of a parity check, answered.
void doubt_identical(std::vector<Question>& questions);

/// Equivalence of two numbers: difference, uncertainty, p-values, and set_outcome().
void judge_difference(Question& question, const compare::EquivalenceQuestion& difference,
                      std::size_t replicas);
/// Sets the outcome, its reason, and whether the catalogue expects it.
void set_outcome(Question& question, compare::Outcome outcome, const std::string& reason);

}  // namespace crossgrain::judge
