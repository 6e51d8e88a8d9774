// The judge itself: decisions at known numbers, error rates on synthetic normal data, and questions
// it must refuse.
#include "reference/compare/equivalence.hpp"

#include "native/base/random.hpp"
#include "reference/compare/student.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::compare;

namespace {

struct Rates {
    double agree = 0, disagree = 0;
};

// Two samples of `n` normal deviates whose means differ by `difference`, compared many times.
Rates rates(double difference, double margin, std::uint64_t n, std::uint64_t seed) {
    constexpr std::uint64_t experiments = 20000;
    Rates found;
    for (std::uint64_t e = 0; e < experiments; ++e) {
        double sum = 0, squares = 0;
        for (std::uint64_t i = 0; i < n; ++i) {
            const auto pair = normal_pair(seed, RandomStream::jitter, e * n + i);
            const double d = pair[0] - pair[1] + difference;  // paired: variance 2
            sum += d;
            squares += d * d;
        }
        const auto count = static_cast<double>(n);
        const double mean = sum / count;
        const double error = std::sqrt((squares / count - mean * mean) / (count - 1));
        const auto answer = equivalence({.difference = mean,
                                         .standard_error = error,
                                         .degrees_of_freedom = count - 1,
                                         .margin = margin});
        if (answer.outcome == Outcome::agree) found.agree += 1.0 / experiments;
        if (answer.outcome == Outcome::disagree) found.disagree += 1.0 / experiments;
    }
    return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(decides_by_the_two_intervals) {
    const auto outcome = [](double difference, double error) {
        return equivalence({.difference = difference,
                            .standard_error = error,
                            .degrees_of_freedom = 10,
                            .margin = 1})
            .outcome;
    };
    // t_{0.95, 10} = 1.8125, t_{0.975, 10} = 2.2281.
    BOOST_TEST((outcome(0.8, 0.110) == Outcome::agree));
    BOOST_TEST((outcome(-0.8, 0.110) == Outcome::agree));
    BOOST_TEST((outcome(0.8, 0.111) == Outcome::undecided));
    BOOST_TEST((outcome(1.2, 0.0898) == Outcome::undecided));
    BOOST_TEST((outcome(1.2, 0.0897) == Outcome::disagree));
    BOOST_TEST((outcome(-1.2, 0.0897) == Outcome::disagree));
    BOOST_TEST((outcome(0.0, 10.0) == Outcome::undecided));
}

BOOST_AUTO_TEST_CASE(false_alarms_stay_at_their_nominal_rates) {
    // At a true difference of exactly the margin: agree in at most 5 % of the experiments, disagree
    // in 2.5 %. 20000 experiments know a rate of 5 % to 0.15 %.
    for (const std::uint64_t n : {5, 12, 40}) {
        const double scatter = std::sqrt(2.0 / static_cast<double>(n));
        const auto at_margin = rates(8 * scatter, 8 * scatter, n, 11);
        BOOST_TEST_MESSAGE("n = " << n << ": false agree " << at_margin.agree << ", false disagree "
                                  << at_margin.disagree);
        BOOST_TEST(at_margin.agree <= 0.06);
        BOOST_TEST(at_margin.agree >= 0.04);
        BOOST_TEST(at_margin.disagree <= 0.03);
        BOOST_TEST(at_margin.disagree >= 0.02);
    }
}

BOOST_AUTO_TEST_CASE(little_data_never_passes_for_agreement) {
    // Margin of two standard errors and no true difference: power is small, and what is not decided
    // is undecided rather than wrong.
    const auto few = rates(0.0, 2 * std::sqrt(2.0 / 5), 5, 12);
    BOOST_TEST(few.disagree <= 0.001);
    const auto many = rates(0.0, 2 * std::sqrt(2.0 / 5), 50, 13);
    BOOST_TEST(many.agree >= 0.999);
}

BOOST_AUTO_TEST_CASE(says_how_many_samples_would_decide) {
    EquivalenceQuestion question{
        .difference = 0.5, .standard_error = 0.4, .degrees_of_freedom = 7, .margin = 1};
    const auto answer = equivalence(question);
    BOOST_TEST((answer.outcome == Outcome::undecided));
    const double width = student_quantile(0.95, 7) * 0.4;
    BOOST_TEST(answer.half_width_90 == width, tt::tolerance(1e-14));
    BOOST_TEST(answer.samples_factor == std::pow(width / 0.5, 2), tt::tolerance(1e-14));
    BOOST_TEST(answer.reason.find("instead of 8") != std::string::npos, answer.reason);
    // With so many samples, and t no larger, it is decided.
    const double factor = answer.samples_factor * 1.001;
    question.standard_error /= std::sqrt(factor);
    question.degrees_of_freedom = 8 * factor - 1;
    BOOST_TEST((equivalence(question).outcome == Outcome::agree));
}

BOOST_AUTO_TEST_CASE(a_difference_of_the_margin_is_never_decided) {
    const auto answer = equivalence({.difference = 1, .standard_error = 0.1, .margin = 1});
    BOOST_TEST((answer.outcome == Outcome::undecided));
    BOOST_TEST(std::isinf(answer.samples_factor));
    BOOST_TEST(answer.reason.find("no number") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_without_scatter_are_compared_plainly) {
    BOOST_TEST((equivalence({.difference = 1e-3, .margin = 1e-3}).outcome == Outcome::agree));
    BOOST_TEST((equivalence({.difference = 0, .margin = 0}).outcome == Outcome::agree));
    const auto answer = equivalence({.difference = -1.1e-3, .margin = 1e-3});
    BOOST_TEST((answer.outcome == Outcome::disagree));
    BOOST_TEST(!answer.reason.empty());
}

BOOST_AUTO_TEST_CASE(a_single_sample_decides_nothing) {
    const auto answer = equivalence(
        {.difference = 0, .standard_error = 1e-6, .degrees_of_freedom = 0, .margin = 1});
    BOOST_TEST((answer.outcome == Outcome::undecided));
    BOOST_TEST(!answer.reason.empty());
}

BOOST_AUTO_TEST_CASE(two_operands_share_their_degrees_of_freedom) {
    const Operand measured{.value = 2, .standard_error = 0.3, .degrees_of_freedom = 3};
    const auto against_exact = question_of(measured, {.value = 1.5}, 1);
    BOOST_TEST(against_exact.difference == 0.5);
    BOOST_TEST(against_exact.standard_error == 0.3);
    BOOST_TEST(against_exact.degrees_of_freedom == 3.0);
    // A published error is taken as known: what remains uncertain is the share of the other.
    const auto against_paper = question_of(measured, {.value = 1.5, .standard_error = 0.4}, 1);
    BOOST_TEST(against_paper.standard_error == 0.5, tt::tolerance(1e-15));
    BOOST_TEST(against_paper.degrees_of_freedom == 3 * std::pow(0.5 / 0.3, 4),
               tt::tolerance(1e-12));
    const auto of_two = question_of(measured, measured, 1);
    BOOST_TEST(of_two.degrees_of_freedom == 6.0, tt::tolerance(1e-12));
    // An error that rests on nothing makes the sum rest on nothing.
    const Operand single{.value = 2, .standard_error = 0.3, .degrees_of_freedom = 0};
    BOOST_TEST(question_of(measured, single, 1).degrees_of_freedom == 0.0);
    BOOST_TEST(question_of(single, {.value = 1}, 1).degrees_of_freedom == 0.0);
}

BOOST_AUTO_TEST_CASE(refuses_questions_that_make_no_sense) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (const EquivalenceQuestion bad :
         {EquivalenceQuestion{.difference = nan, .standard_error = 1, .margin = 1},
          EquivalenceQuestion{.difference = infinite, .standard_error = 1, .margin = 1},
          EquivalenceQuestion{.difference = 0, .standard_error = nan, .margin = 1},
          EquivalenceQuestion{.difference = 0, .standard_error = -1, .margin = 1},
          EquivalenceQuestion{.difference = 0, .standard_error = 1, .margin = 0},
          EquivalenceQuestion{.difference = 0, .standard_error = 1, .margin = -1},
          EquivalenceQuestion{.difference = 0, .standard_error = 0, .margin = nan},
          EquivalenceQuestion{
              .difference = 0, .standard_error = 1, .degrees_of_freedom = nan, .margin = 1}}) {
        BOOST_CHECK_THROW(static_cast<void>(equivalence(bad)), std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(a_quotient_carries_both_errors_and_the_fewer_degrees_of_freedom) {
    const Operand six{.value = 6, .standard_error = 0.3, .degrees_of_freedom = 5};
    const Operand two{.value = -2, .standard_error = 0.2, .degrees_of_freedom = 3};
    const Operand quotient = quotient_of(six, two);
    BOOST_TEST(quotient.value == -3.0);
    // Relative errors of 5 % and 10 % add in squares.
    BOOST_TEST(quotient.standard_error == 3 * std::hypot(0.05, 0.1), tt::tolerance(1e-14));
    BOOST_TEST(quotient.degrees_of_freedom == 3.0);
    BOOST_TEST(quotient_of(six, {.value = 2}).standard_error == 0.15, tt::tolerance(1e-14));
}
