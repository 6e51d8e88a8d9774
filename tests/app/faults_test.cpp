// Calls that are killed, or asked to end, at random moments: nobody is left behind, the store is
// whole, and the next call goes on as if nothing had happened. CROSSGRAIN_FAULT_MOMENTS says how
// many moments per signal and code; CROSSGRAIN_FAULT_SEED repeats the moments of an earlier run.
#include "adapters/process/find_program.hpp"
#include "tests/app/interrupted_call.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>

#include <sys/stat.h>

using namespace crossgrain::tests;

namespace {

constexpr std::array signals{SIGKILL, SIGHUP, SIGQUIT, SIGPIPE, SIGTERM, SIGINT};
/// A stop takes a moment at most; where it is not heard it takes five seconds.
constexpr double longest_stop = 20, longest_call = 120;

unsigned long from_environment(const char* name, unsigned long otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::strtoul(text, nullptr, 10) : otherwise;
}

std::mt19937_64& random_numbers() {
    static std::mt19937_64 engine = [] {
        const auto seed = from_environment("CROSSGRAIN_FAULT_SEED", std::random_device()());
        std::cout << "CROSSGRAIN_FAULT_SEED=" << seed << std::endl;
        return std::mt19937_64(seed);
    }();
    return engine;
}

std::string test_case(const std::string& name) {
    return CROSSGRAIN_SOURCE_DIR "/tests/app/cases/" + name + ".toml";
}

/// The test's case, so long that the code takes a moment for it.
std::string case_of_length(const CallSite& site, double contact_times) {
    std::ifstream in(test_case("interrupted-gas"));
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const auto replace = [&](const std::string& from, const std::string& to) {
        const auto at = text.find(from);
        if (at == std::string::npos) throw std::logic_error("test case lacks: " + from);
        text.replace(at, from.size(), to);
    };
    replace("contact_times = 400.0", "contact_times = " + std::to_string(contact_times));
    replace("every_contact_times = 4.0",
            "every_contact_times = " + std::to_string(contact_times / 100));
    const auto path = site.directory() / "interrupted-gas.toml";
    std::ofstream(path) << text;
    return path.string();
}

struct Subject {
    std::string code;
    double contact_times = 0;  ///< of its runs
    unsigned long moments = 0;
    int replicas = 0;
};

class Trial {
  public:
    explicit Trial(const Subject& subject)
        : subject_(subject), file_(case_of_length(place_, subject.contact_times)) {
        CallSite calm;
        calm.start(call());
        const auto end = calm.wait(longest_call);
        BOOST_TEST_REQUIRE(end.status == 0);
        seconds_ = end.seconds;
        expected_ = stored_in(calm.results());
        BOOST_TEST_REQUIRE(expected_.measurements.size() ==
                           static_cast<std::size_t>(subject.replicas));
    }

    void operator()(int signal) {
        // From before it listens until after its end.
        const double moment =
            std::uniform_real_distribution<double>(0, 1.05 * seconds_)(random_numbers());
        BOOST_TEST_CONTEXT(subject_.code << ", signal " << signal << " after " << moment << " s") {
            CallSite site;
            site.start(call());
            std::this_thread::sleep_for(std::chrono::duration<double>(moment));
            site.send(signal);
            const auto end = site.wait(longest_stop);
            check_end(site, end, signal);
            interrupted_ += end.status == 0 ? 0 : 1;
            BOOST_TEST(site.nobody_left());
            check_next_call(site);
        }
    }

    /// How many calls the signal reached in time.
    [[nodiscard]] int interrupted() const { return interrupted_; }

  private:
    [[nodiscard]] std::vector<std::string> call() const {
        return {"run",         file_,        "--code",
                subject_.code, "--replicas", std::to_string(subject_.replicas),
                "--jobs",      "2"};
    }

    static void check_end(const CallSite& site, const CallEnd& end, int signal) {
        BOOST_TEST(end.ended);
        if (end.signal != 0) {
            // Otherwise it was too early for the program to hear anything.
            BOOST_TEST(end.signal == signal);
            if (signal != SIGKILL) BOOST_TEST(!std::filesystem::exists(site.results()));
        } else {
            BOOST_TEST((end.status == 130 || end.status == 0));
        }
    }

    /// It computes what is missing and nothing else, and cleans up.
    void check_next_call(CallSite& site) const {
        const Stored before = stored_in(site.results());
        BOOST_TEST(before.integrity == "ok");
        for (const auto& [key, text] : before.measurements) {
            BOOST_TEST(expected_.measurements.contains(key));
            if (expected_.measurements.contains(key))
                BOOST_TEST(text == expected_.measurements.at(key));
        }
        site.start(call());
        BOOST_TEST(site.wait(longest_call).status == 0);
        const Stored after = stored_in(site.results());
        BOOST_TEST(after.integrity == "ok");
        BOOST_TEST((after.measurements == expected_.measurements));
        BOOST_TEST(
            std::ranges::all_of(after.times, [](const auto& entry) { return entry.second == 1; }));
        BOOST_TEST(site.left_directories() == std::vector<std::string>(),
                   boost::test_tools::per_element());
        BOOST_TEST(site.nobody_left());
    }

    CallSite place_;
    Subject subject_;
    std::string file_;
    double seconds_ = 0;
    Stored expected_;
    int interrupted_ = 0;
};

void check_code(Subject subject) {
    const bool native = subject.code == "native-dem";
    const std::string program = subject.code == "lammps" ? "lmp" : subject.code;
    if (!native && !crossgrain::adapters::process::find_program(program)) {
        BOOST_TEST_MESSAGE(subject.code << " is not installed: skipped");
        return;
    }
    subject.moments = from_environment("CROSSGRAIN_FAULT_MOMENTS", subject.moments);
    Trial trial(subject);
    for (unsigned long moment = 0; moment < subject.moments; ++moment) {
        for (const int signal : signals)
            trial(signal);
    }
    // Or the moments are not what they are meant to be.
    BOOST_TEST(trial.interrupted() > 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(native_runs) {
    check_code({.code = "native-dem", .contact_times = 8'000, .moments = 6, .replicas = 4});
}

BOOST_AUTO_TEST_CASE(lammps_runs) {
    check_code({.code = "lammps", .contact_times = 400, .moments = 1, .replicas = 3});
}

BOOST_AUTO_TEST_CASE(liggghts_runs) {
    check_code({.code = "liggghts", .contact_times = 400, .moments = 1, .replicas = 3});
}

BOOST_AUTO_TEST_CASE(yade_runs) {
    check_code({.code = "yade", .contact_times = 40, .moments = 1, .replicas = 3});
}

/// What the program does before its first run: signals are heard there as well.
BOOST_AUTO_TEST_CASE(phases_before_the_first_run) {
    CallSite place;
    const auto pipe = place.directory() / "case.toml";
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const std::vector<std::vector<std::string>> calls{
        {"codes"},
        {"run", test_case("interrupted-gas"), "--code", "native-dem", "--replicas", "4000"},
        {"run", test_case("slow-filling")},
        {"run", pipe.string(), "--code", "native-dem"},
        {"read", test_case("small-gas"), pipe.string(), "--code", "other"},
        {"compare"}};
    const auto moments = from_environment("CROSSGRAIN_FAULT_MOMENTS", 6);
    for (unsigned long moment = 0; moment < 2 * moments; ++moment) {
        for (const auto& call : calls) {
            const int signal = signals[random_numbers()() % signals.size()];
            const double after = std::uniform_real_distribution<double>(0, 0.8)(random_numbers());
            BOOST_TEST_CONTEXT(call.front() << ' ' << call.back() << ", signal " << signal
                                            << " after " << after << " s") {
                CallSite site;
                site.start(call);
                std::this_thread::sleep_for(std::chrono::duration<double>(after));
                site.send(signal);
                const auto end = site.wait(longest_stop);
                BOOST_TEST(end.ended);
                BOOST_TEST(site.nobody_left());
                BOOST_TEST(stored_in(site.results()).integrity == "ok");
                if (call.front() != "codes") continue;
                site.start(call);
                BOOST_TEST(site.wait(longest_call).status == 0);
                BOOST_TEST(site.left_directories().empty());
            }
        }
    }
}
