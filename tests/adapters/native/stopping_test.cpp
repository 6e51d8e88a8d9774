// A run ends when the user, the clock or the physics says so, and says which it was.
#include "adapters/native/native_dem_code.hpp"
#include "native/base/errors.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <string>

using namespace crossgrain;
using adapters::NativeDemCode;

namespace {

const NativeDemCode code("test");

/// Days of computing.
scene::Scene endless() {
    auto s = tests::doubly_periodic_gas();
    s.frame_every = 1'000'000'000'000;
    s.steps = s.frame_every;
    return s;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

AdapterErrorDetails failure(
    const scene::Scene& s, double time_limit, const scene::FrameSink& sink = [](const auto&) {}) {
    const tests::TemporaryDirectory directory;
    try {
        (void)code.run(s, {.directory = directory.path(), .time_limit = time_limit, .stop = {}},
                       sink);
    } catch (const AdapterError& error) {
        BOOST_TEST(std::string(error.what()).find('\n') == std::string::npos);
        BOOST_TEST(error.details().directory == directory.path().string());
        return error.details();
    }
    BOOST_ERROR("the run did not fail");
    return {};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_stop_request_before_the_start_interrupts) {
    std::stop_source source;
    source.request_stop();
    const tests::TemporaryDirectory directory;
    BOOST_CHECK_THROW(
        (void)code.run(
            endless(),
            {.directory = directory.path(), .time_limit = 60, .stop = source.get_token()},
            [](const auto&) {}),
        Interrupted);
}

BOOST_AUTO_TEST_CASE(a_stop_request_during_the_run_interrupts_soon) {
    std::stop_source source;
    std::int64_t frames = 0;
    auto s = endless();
    s.frame_every = 10;
    const tests::TemporaryDirectory directory;
    const auto start = std::chrono::steady_clock::now();
    BOOST_CHECK_THROW(
        (void)code.run(
            s, {.directory = directory.path(), .time_limit = 60, .stop = source.get_token()},
            [&](const auto&) {
                if (++frames == 5) source.request_stop();
            }),
        Interrupted);
    BOOST_TEST(frames == 5);
    BOOST_TEST(seconds_since(start) < 5);
}

BOOST_AUTO_TEST_CASE(the_time_limit_fails_the_run_soon_after_it_is_over) {
    const auto start = std::chrono::steady_clock::now();
    const auto error = failure(endless(), 0.1);
    BOOST_TEST(error.code == "native-dem");
    BOOST_TEST(error.reason == "stopped at the time limit of 0.1 s");
    BOOST_TEST(seconds_since(start) >= 0.1);
    BOOST_TEST(seconds_since(start) < 5);  // a block of 1000 steps, on a busy machine
}

BOOST_AUTO_TEST_CASE(an_absurd_time_step_fails_the_run_with_the_reason) {
    auto s = tests::doubly_periodic_gas();
    s.dt = 1;  // ten contact times: grains jump over each other
    s.frame_every = 1;
    s.steps = 1000;
    const auto error = failure(s, 60);
    BOOST_TEST(error.code == "native-dem");
    BOOST_TEST(error.reason.find("dt = 1 is too large") != std::string::npos, error.reason);
}

BOOST_AUTO_TEST_CASE(a_run_that_blows_up_between_two_frames_fails_as_well) {
    auto s = tests::doubly_periodic_gas();
    s.initial.vx[0] = 0.9;
    s.dt = 0.5;
    s.frame_every = s.steps = 1'000'000;
    const auto error = failure(s, 60);
    BOOST_TEST(!error.reason.empty());
    BOOST_TEST(error.reason.find("time limit") == std::string::npos, error.reason);
}

BOOST_AUTO_TEST_CASE(a_run_that_turns_into_no_number_fails_as_well) {
    auto s = tests::doubly_periodic_gas();
    s.contact.stiffness = std::numeric_limits<double>::max();
    s.frame_every = s.steps = 1'000'000;
    const auto error = failure(s, 60);
    BOOST_TEST(!error.reason.empty());
    BOOST_TEST(error.reason.find("time limit") == std::string::npos, error.reason);
}

BOOST_AUTO_TEST_CASE(what_the_sink_throws_comes_out) {
    const tests::TemporaryDirectory directory;
    BOOST_CHECK_THROW((void)code.run(tests::head_on_pair(),
                                     {.directory = directory.path(), .time_limit = 60, .stop = {}},
                                     [](const auto&) { throw std::domain_error("mine"); }),
                      std::domain_error);
}
