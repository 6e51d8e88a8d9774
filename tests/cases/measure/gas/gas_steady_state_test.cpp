// Each state of a run gets its word, and none gets another's: the word goes beside every exponent.
#include "cases/measure/gas/gas_steady_state.hpp"

#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <string>

using namespace crossgrain;
using tests::SyntheticGas;

namespace {

scene::GasSampling sampling(bool periodic = true) {
    return {.length = 200,
            .width = 11,
            .periodic = periodic,
            .bin = 10,
            .replicas = 16,
            .steps = 4000,
            .every = 10,
            .fields = {.count = true, .rests = true, .momentum = true}};
}

/// Fraction of the run that is over.
double elapsed(const SyntheticGas& gas) {
    return static_cast<double>(gas.step) / 4000;
}

/// Counts of deviation `spread`, a share of them at rest, all of it fluctuating.
class Gas {
  public:
    std::function<double(double)> level = [](double) { return 200; };
    std::function<double(double)> spread = [](double) { return 10; };
    std::function<double(double)> rests = [](double) { return 60; };

    void operator()(SyntheticGas& gas) {
        const double t = elapsed(gas);
        for (std::size_t j = 0; j < gas.count.size(); ++j) {
            gas.count[j] = static_cast<std::uint16_t>(level(t) + spread(t) * tests::white(1, n_++));
            if (!gas.rests.empty()) {
                gas.rests[j] = static_cast<std::uint16_t>(rests(t) + 5 * tests::white(1, n_++));
                gas.momentum[j] = static_cast<std::int16_t>(50 + 10 * tests::white(1, n_++));
            }
        }
    }

  private:
    std::uint64_t n_ = 0;
};

template <class Fill>
measure::Results measured(const scene::GasSampling& s, Fill fill) {
    measure::GasSteadyState state(s, {});
    return tests::run_gas<measure::GasSteadyState>(s, state, [&](SyntheticGas& gas) { fill(gas); });
}

std::string state_of(const measure::Results& results) {
    BOOST_TEST_REQUIRE(results.findings.size() == 1U);
    BOOST_TEST(results.findings[0].name == "state");
    BOOST_TEST(!results.findings[0].detail.empty());
    return results.findings[0].label;
}

double value(const measure::Results& results, const std::string& name) {
    for (const auto& m : results.measurements) {
        if (m.observable == name) return m.value;
    }
    BOOST_FAIL("no " + name);
    return 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fluctuations_around_the_same_values_are_steady) {
    const auto results = measured(sampling(), Gas());
    BOOST_TEST(state_of(results) == "steady");
    BOOST_TEST(std::abs(value(results, "drift_rests")) < 0.01);
    BOOST_TEST(value(results, "absorbing_fraction") == 0);
    BOOST_TEST(state_of(measured(sampling(false), Gas())) == "steady");
}

BOOST_AUTO_TEST_CASE(a_drift_of_rests_or_of_structure_is_ageing) {
    Gas cooling;
    cooling.rests = [](double t) { return 60 + 10 * t; };
    const auto results = measured(sampling(), cooling);
    BOOST_TEST(state_of(results) == "ageing");
    BOOST_TEST(std::abs(value(results, "drift_rests") - 7.5 / 65) < 0.01);
    Gas smoothing;
    smoothing.spread = [](double t) { return 12 - 3 * t; };
    BOOST_TEST(state_of(measured(sampling(), smoothing)) == "ageing");
}

BOOST_AUTO_TEST_CASE(a_drift_within_the_tolerance_is_steady_however_certain) {
    Gas slow;
    slow.rests = [](double t) { return 60 + 2 * t; };
    BOOST_TEST(state_of(measured(sampling(), slow)) == "steady");
}

BOOST_AUTO_TEST_CASE(where_nothing_happens_any_more_is_absorbing) {
    // A stream in free fall: the counts go on changing, rests and momentum do not.
    const auto results = measured(sampling(), [fluctuating = Gas()](SyntheticGas& gas) mutable {
        if (elapsed(gas) < 0.5) return fluctuating(gas);
        for (std::size_t i = 0; i < gas.bins; ++i) {
            for (std::size_t r = 0; r < gas.replicas; ++r) {
                const std::size_t j = i * gas.replicas + r;
                gas.count[j] = static_cast<std::uint16_t>(
                    100 + (i + static_cast<std::size_t>(gas.step) / 10) % gas.bins);
                gas.rests[j] = 30;
                gas.momentum[j] = 140;
            }
        }
    });
    BOOST_TEST(state_of(results) == "absorbing");
    BOOST_TEST(value(results, "absorbing_fraction") == 1);
    // Without rests and momentum only complete standstill is seen.
    auto s = sampling();
    s.fields.rests = s.fields.momentum = false;
    BOOST_TEST(state_of(measured(s, [](SyntheticGas& gas) {
                   gas.fill(
                       [](std::size_t bin, std::size_t) { return 100 + static_cast<double>(bin); });
               })) == "absorbing");
    // An empty pipe too.
    BOOST_TEST(state_of(measured(sampling(false), [](SyntheticGas&) {})) == "absorbing");
}

BOOST_AUTO_TEST_CASE(an_open_pipe_that_fills_up_is_clogged_one_that_has_filled_is_not) {
    Gas clogging;
    clogging.level = [](double t) { return 150 + 100 * t; };
    BOOST_TEST(state_of(measured(sampling(false), clogging)) == "clogged");
    Gas filled;
    filled.level = [](double t) { return t < 0.1 ? 200 + 1000 * (t - 0.1) : 200; };
    filled.rests = [](double t) { return t < 0.1 ? 50 : 60; };
    const auto results = measured(sampling(false), filled);
    BOOST_TEST(state_of(results) == "ageing");  // the measured part holds the filling
    BOOST_TEST(value(results, "drift_particles") > 0.05);
}

BOOST_AUTO_TEST_CASE(saturation_is_said_whenever_it_comes) {
    const auto s = sampling();
    measure::GasSteadyState state(s, {});
    SyntheticGas gas(s);
    Gas fill;
    for (int f = 0; f < 7; ++f) {
        gas.step = 10 * f;
        fill(gas);
        state.add(gas.view());
    }
    gas.step = 63;
    gas.saturated.assign(16, 0);
    gas.saturated[3] = gas.saturated[9] = 1;
    state.add(gas.view());
    measure::Results results;
    state.finish(results);
    BOOST_TEST(state_of(results) == "saturated");
    BOOST_TEST(value(results, "saturated_fraction") == 0.125);
    BOOST_TEST(results.findings[0].detail.find("step 63 in 2 of 16") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_run_that_ends_early_has_no_state) {
    measure::GasSteadyState state(sampling(), {});
    SyntheticGas gas(sampling());
    state.add(gas.view());
    measure::Results results;
    state.finish(results);
    BOOST_TEST(results.findings.empty());
    BOOST_TEST(results.measurements.empty());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_judged_is_refused) {
    auto s = sampling();
    s.replicas = 3;
    BOOST_CHECK_THROW(measure::GasSteadyState(s, {}), std::invalid_argument);
    s = sampling();
    s.fields.count = false;
    BOOST_CHECK_THROW(measure::GasSteadyState(s, {}), std::invalid_argument);
    s = sampling();
    s.steps = 140;
    BOOST_CHECK_THROW(measure::GasSteadyState(s, {}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::GasSteadyState(sampling(), {.tolerance = 0}), std::invalid_argument);
}
