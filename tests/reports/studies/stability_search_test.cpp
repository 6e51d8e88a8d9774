// The search for a largest stable time step, on a code whose threshold is known: what it finds,
// that it ends, and that the store spares the next call.
#include "native/base/errors.hpp"
#include "reports/studies/stability/stability_search.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>

using namespace crossgrain;
using studies::ThresholdSearch;

namespace {

/// One grain whose velocity grows or dies away, by the time step.
class KnownCode final : public adapters::GrainCode {
  public:
    explicit KnownCode(double limit) : limit_(limit) {}

    mutable int runs = 0;

    std::string name() const override { return "known"; }
    adapters::Availability probe(std::stop_token = {}) const override {
        return {.installed = true, .version = "1"};
    }
    std::vector<std::string> features() const override { return {}; }
    std::optional<std::string> cannot_express(const scene::Scene&) const override {
        return std::nullopt;
    }
    std::vector<adapters::InputFile> input(const scene::Scene&) const override { return {}; }

    adapters::RunCost run(const scene::Scene& scene, const adapters::RunOptions&,
                          const scene::FrameSink& sink) const override {
        ++runs;
        // Far beyond the threshold a code gives up, as they do.
        if (scene.dt > 2 * limit_)
            throw AdapterError({.code = "known", .reason = "left all bounds"});
        const double rate = scene.dt > limit_ ? 1e-3 : -1e-3;
        for (std::int64_t step = 0; step <= scene.steps; step += scene.frame_every) {
            const std::array zero{0.0}, speed{std::exp(rate * static_cast<double>(step))};
            scene::Frame frame;
            frame.step = step;
            frame.x = frame.y = frame.vy = zero;
            frame.vx = speed;
            sink(frame);
        }
        return {};
    }

  private:
    double limit_;
};

run::Settings settings_in(const std::filesystem::path& directory) {
    run::Settings settings;
    settings.results = directory;
    settings.jobs = 2;
    return settings;
}

studies::ThresholdSearch search_of(const KnownCode& code, double guess) {
    studies::ThresholdSearch search{.code = &code, .version = "1", .guess = guess};
    search.packing.initial.x = {0.0};
    search.result.code = code.name();
    return search;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_threshold_is_found_whatever_the_guess) {
    for (const double guess : {0.03, 0.012, 0.09}) {
        const tests::TemporaryDirectory directory;
        store::Store store(directory.path());
        const KnownCode code(0.03);
        const auto found = studies::find_thresholds({search_of(code, guess)}, "a-case",
                                                    settings_in(directory.path()), store, {});
        BOOST_TEST_REQUIRE(found.size() == 1u);
        BOOST_TEST(found[0].works <= 0.03);
        BOOST_TEST(found[0].fails > 0.03);
        BOOST_TEST(found[0].fails / found[0].works < 1.0051);
    }
}

BOOST_AUTO_TEST_CASE(where_nothing_works_the_search_ends) {
    const tests::TemporaryDirectory directory;
    store::Store store(directory.path());
    const KnownCode code(1e-6);
    const auto found = studies::find_thresholds({search_of(code, 0.03)}, "a-case",
                                                settings_in(directory.path()), store, {});
    BOOST_TEST_REQUIRE(found.size() == 1u);
    BOOST_TEST(found[0].works == 0.0);
    BOOST_TEST(code.runs < 30);
}

BOOST_AUTO_TEST_CASE(what_the_store_has_is_not_searched_for_again) {
    const tests::TemporaryDirectory directory;
    store::Store store(directory.path());
    const KnownCode code(0.03);
    const auto call = [&](double guess) {
        return studies::find_thresholds({search_of(code, guess)}, "a-case",
                                        settings_in(directory.path()), store, {});
    };
    const auto first = call(0.03);
    const int runs = code.runs;
    const auto second = call(0.03);
    BOOST_TEST(code.runs == runs);
    BOOST_TEST(second.at(0).works == first.at(0).works);
    BOOST_TEST(second.at(0).fails == first.at(0).fails);
    // Another search is another question.
    (void)call(0.031);
    BOOST_TEST(code.runs > runs);
}

BOOST_AUTO_TEST_CASE(a_search_that_was_stopped_is_missing) {
    const tests::TemporaryDirectory directory;
    store::Store store(directory.path());
    const KnownCode code(0.03);
    std::stop_source stop;
    stop.request_stop();
    BOOST_TEST(studies::find_thresholds({search_of(code, 0.03)}, "a-case",
                                        settings_in(directory.path()), store, stop.get_token())
                   .empty());
}
