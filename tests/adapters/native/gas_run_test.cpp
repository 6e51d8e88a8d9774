// The lattice gas behind the interface of all codes: frames on schedule, both engines the same, and
// a run that ends early says why.
#include "adapters/native/native_gas_code.hpp"
#include "native/base/errors.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numeric>
#include <stop_token>
#include <string>
#include <vector>

using namespace crossgrain;
using adapters::NativeGasCode;

namespace {

const NativeGasCode code("test");

/// Two head on turn or stop, in a small periodic pipe.
scene::LatticeGas gas() {
    scene::LatticeGas s;
    s.name = "gas";
    s.reading.name = "two";
    s.reading.file = "two.toml";
    for (int i = 0; i < 3; ++i) {
        const auto pair = [&](int k) {
            return scene::SiteState{
                .movers = static_cast<std::uint8_t>(1U << (k % 6) | 1U << ((k + 3) % 6))};
        };
        s.reading.rows.push_back(
            {.before = pair(i), .after = pair(i + 1), .probability = {0.5, -0.5}, .line = i});
        s.reading.rows.push_back({.before = pair(i),
                                  .after = {.movers = 0, .rests = 2},
                                  .probability = {0, 1},
                                  .line = i});
    }
    s.sampling = {.length = 20,
                  .width = 5,
                  .periodic = true,
                  .bin = 5,
                  .replicas = 70,
                  .burn_in = 30,
                  .steps = 40,
                  .every = 20,
                  .fields = {.count = true, .rests = true, .momentum = true}};
    s.density = 1.2;
    s.dissipation = 0.4;
    s.gravity = 0.5;
    s.roughness = 0.5;
    s.seed = 5;
    return s;
}

/// What a frame held, kept.
struct Kept {
    std::int64_t step;
    std::vector<std::uint16_t> count, rests;
    std::vector<std::int16_t> momentum;
    std::vector<std::uint8_t> saturated;
    friend bool operator==(const Kept&, const Kept&) = default;
};

std::vector<Kept> frames_of(const scene::LatticeGas& s) {
    std::vector<Kept> all;
    const tests::TemporaryDirectory directory;
    (void)code.run(s, {.directory = directory.path(), .time_limit = 60, .stop = {}},
                   [&](const scene::GasFrame& f) {
                       all.push_back({f.step,
                                      {f.count.begin(), f.count.end()},
                                      {f.rests.begin(), f.rests.end()},
                                      {f.momentum.begin(), f.momentum.end()},
                                      {f.saturated.begin(), f.saturated.end()}});
                   });
    return all;
}

std::string failure(const scene::LatticeGas& s, double time_limit = 60) {
    const tests::TemporaryDirectory directory;
    try {
        (void)code.run(s, {.directory = directory.path(), .time_limit = time_limit, .stop = {}},
                       [](const auto&) {});
    } catch (const AdapterError& error) {
        BOOST_TEST(error.details().code == "native-lga");
        BOOST_TEST(error.details().reason.find('\n') == std::string::npos);
        return error.details().reason;
    }
    BOOST_ERROR("the run did not fail");
    return {};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Rests only accumulate.
scene::LatticeGas jammed() {
    auto s = gas();
    s.density = 3;
    s.dissipation = 1;
    s.gravity = 0;
    s.sampling.steps = 100'000;
    return s;
}

}  // namespace

BOOST_AUTO_TEST_CASE(frames_come_on_schedule_with_what_was_asked_for) {
    const auto s = gas();
    const auto frames = frames_of(s);
    BOOST_TEST_REQUIRE(frames.size() == 3U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        BOOST_TEST(frames[i].step == 30 + 20 * static_cast<std::int64_t>(i));
        BOOST_TEST(frames[i].count.size() == 4U * 70U);
        BOOST_TEST(frames[i].rests.size() == 4U * 70U);
        BOOST_TEST(frames[i].momentum.size() == 4U * 70U);
        BOOST_TEST(frames[i].saturated.empty());
        BOOST_TEST(std::accumulate(frames[i].count.begin(), frames[i].count.end(), 0) == 120 * 70);
    }
}

BOOST_AUTO_TEST_CASE(fields_that_are_not_asked_for_are_empty) {
    auto s = gas();
    s.sampling.fields = {.count = false, .rests = true, .momentum = false};
    const auto frames = frames_of(s);
    BOOST_TEST(frames.front().count.empty());
    BOOST_TEST(!frames.front().rests.empty());
    BOOST_TEST(frames.front().momentum.empty());
}

BOOST_AUTO_TEST_CASE(both_engines_give_the_same_frames) {
    auto s = gas();
    const auto sliced = frames_of(s);
    s.engine = scene::GasEngine::table;
    BOOST_TEST((frames_of(s) == sliced));
}

BOOST_AUTO_TEST_CASE(the_first_frame_without_burn_in_is_the_initial_state) {
    auto s = gas();
    s.sampling.burn_in = 0;
    const auto frames = frames_of(s);
    BOOST_TEST(frames.front().step == 0);
    for (const auto rests : frames.front().rests)
        BOOST_TEST(rests == 0);
}

BOOST_AUTO_TEST_CASE(saturation_fails_the_run_with_time_density_and_saturation) {
    const auto reason = failure(jammed());
    BOOST_TEST(contains(reason, "saturated at step "), reason);
    BOOST_TEST(contains(reason, "of 70 replicas"), reason);
    BOOST_TEST(contains(reason, "the density is 3 and 1."), reason);
}

BOOST_AUTO_TEST_CASE(saturation_can_be_a_result) {
    auto s = jammed();
    s.on_saturation = scene::OnSaturation::record;
    const auto frames = frames_of(s);
    BOOST_TEST(frames.back().saturated.size() == 70U);
    BOOST_TEST(std::accumulate(frames.back().saturated.begin(), frames.back().saturated.end(), 0) >
               0);
    BOOST_TEST(std::accumulate(frames.back().count.begin(), frames.back().count.end(), 0) ==
               300 * 70);
    s.engine = scene::GasEngine::table;
    BOOST_TEST((frames_of(s) == frames));
}

BOOST_AUTO_TEST_CASE(a_table_that_does_not_conserve_fails_the_run_with_its_place) {
    auto s = gas();
    s.reading.rows.front().after.movers = 1;
    s.reading.rows.front().line = 12;
    const auto reason = failure(s);
    BOOST_TEST(contains(reason, "two.toml:12"), reason);
    BOOST_TEST(contains(reason, "does not conserve mass"), reason);
}

BOOST_AUTO_TEST_CASE(the_time_limit_and_the_user_stop_a_run_soon) {
    auto s = gas();
    s.sampling.steps = s.sampling.every = 1'000'000'000;
    BOOST_TEST(failure(s, 0.1) == "stopped at the time limit of 0.1 s");
    std::stop_source source;
    source.request_stop();
    const tests::TemporaryDirectory directory;
    BOOST_CHECK_THROW(
        (void)code.run(
            s, {.directory = directory.path(), .time_limit = 60, .stop = source.get_token()},
            [](const auto&) {}),
        Interrupted);
}

BOOST_AUTO_TEST_CASE(a_kept_dump_has_a_line_per_frame_bin_and_replica) {
    const tests::TemporaryDirectory directory;
    auto s = gas();
    s.sampling.fields.rests = false;
    (void)code.run(s,
                   {.directory = directory.path(), .time_limit = 60, .stop = {}, .keep_dump = true},
                   [](const auto&) {});
    std::ifstream file(directory.path() / "frames.csv");
    std::string line;
    std::getline(file, line);
    BOOST_TEST(line == "step,bin,replica,count,rests,momentum");
    std::getline(file, line);
    BOOST_TEST(line.starts_with("30,0,0,"), line);
    BOOST_TEST(contains(line, ",,"), line);
    BOOST_TEST(std::distance(std::istreambuf_iterator<char>(file), {}) > 0);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_a_frame_is_not_expressible) {
    auto s = gas();
    BOOST_TEST(!code.cannot_express(s).has_value());
    s.sampling.replicas = 513;
    BOOST_TEST(code.cannot_express(s).has_value());
    s = gas();
    s.sampling.length = s.sampling.bin = 20'000;
    BOOST_TEST(code.cannot_express(s).has_value());
}

BOOST_AUTO_TEST_CASE(the_input_is_the_scene) {
    const auto files = code.input(gas());
    BOOST_TEST_REQUIRE(files.size() == 1U);
    BOOST_TEST(nlohmann::json::parse(files.front().text).at("seed") == 5);
}
