// Protects the certificate: a defect in the input of one code only must be found. Each real code
// runs the scene with one planted defect against the native engine with the scene as it is.
#include "adapters/registry/codes.hpp"
#include "adapters/run/plan.hpp"
#include "adapters/run/runner.hpp"
#include "reference/judge/evaluate.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <functional>
#include <iostream>
#include <ostream>

using namespace crossgrain;
using scene::Scene;

namespace {

struct Defect {
    std::string name;
    std::string case_name;
    std::function<void(Scene&)> plant;
    std::vector<std::string> not_expressible_in;
};

std::ostream& operator<<(std::ostream& out, const Defect& defect) {
    return out << defect.name;
}

const std::vector<Defect>& defects() {
    static const std::vector<Defect> all{
        {"doubled damping", "small-gas", [](Scene& s) { s.contact.damping *= 2; }, {}},
        {"spins left on",
         "small-gas",
         [](Scene& s) { s.contact.spins = scene::Spins::on; },
         // its law takes one lever arm for the velocity and another for the torque
         {"lammps"}},
        {"damping on the normal only",
         "small-gas",
         [](Scene& s) { s.contact.damping_acts_on = scene::Damping::normal_only; },
         {}},
        {"attraction clipped",
         "small-gas",
         [](Scene& s) { s.contact.clipping = scene::Clipping::all; },
         {}},
        {"stiffness 1 % off", "small-gas", [](Scene& s) { s.contact.stiffness *= 1.01; }, {}},
        {"plate shifted by the radius",
         "small-bed",
         [](Scene& s) { s.plates.touches = scene::PlateContact::surface; },
         {}},
        {"g 1 % off", "small-bed", [](Scene& s) { s.gravity *= 1.01; }, {}},
        {"lid mass 1 % off",
         "small-bed",
         [](Scene& s) { std::get<scene::FreeLid>(s.plates.lid).mass *= 1.01; },
         {}},
    };
    return all;
}

/// A code whose input has the defect, while everybody else believes in the scene as it is.
class DefectiveCode final : public adapters::GrainCode {
  public:
    DefectiveCode(const adapters::GrainCode& code, std::function<void(Scene&)> plant)
        : code_(code), plant_(std::move(plant)) {}

    [[nodiscard]] std::string name() const override { return code_.name(); }
    [[nodiscard]] adapters::Availability probe(std::stop_token = {}) const override {
        return code_.probe();
    }
    [[nodiscard]] std::vector<std::string> features() const override { return code_.features(); }
    [[nodiscard]] std::optional<std::string> cannot_express(const Scene& scene) const override {
        return code_.cannot_express(changed(scene));
    }
    [[nodiscard]] std::vector<adapters::InputFile> input(const Scene& scene) const override {
        return code_.input(changed(scene));
    }
    adapters::RunCost run(const Scene& scene, const adapters::RunOptions& options,
                          const scene::FrameSink& sink) const override {
        return code_.run(changed(scene), options, sink);
    }

  private:
    [[nodiscard]] Scene changed(Scene scene) const {
        plant_(scene);
        return scene;
    }

    const adapters::GrainCode& code_;
    std::function<void(Scene&)> plant_;
};

const std::vector<std::string> foreign_codes{"lammps", "liggghts", "yade"};

/// Certificate of native-dem against one code, whose scene is changed by `plant`.
compare::Outcome certify(const std::string& case_name, const std::string& code,
                         const std::function<void(Scene&)>& plant) {
    const tests::TemporaryDirectory directory;
    run::Settings settings;
    settings.results = directory.path();
    const auto the_case = catalog::load_case(
        CROSSGRAIN_SOURCE_DIR "/tests/app/cases/" + case_name + ".toml", catalog::Suite::quick);
    const DefectiveCode defective(
        dynamic_cast<const adapters::GrainCode&>(*adapters::select_codes({code}).front()), plant);
    auto runs =
        run::plan(the_case, {adapters::select_codes({"native-dem"}).front(), &defective}, settings);
    store::Store store(settings.results);
    auto summary = run::carry_out(std::move(runs), store, settings, {}, true);
    const published::PublishedValues literature(CROSSGRAIN_SOURCE_DIR "/reference/published");
    const auto evaluation =
        judge::evaluate(judge::CaseRuns(the_case, std::move(summary.records)), literature);
    return evaluation.certificate.at(0).outcome;
}

bool absent(const std::string& code) {
    const auto* found = adapters::select_codes({code}).front();
    if (found->probe().installed) return false;
    std::cerr << "SKIPPED: " << code << " is not installed" << std::endl;
    return true;
}

}  // namespace

BOOST_DATA_TEST_CASE(the_same_input_is_certified,
                     boost::unit_test::data::make(foreign_codes) *
                         boost::unit_test::data::make(std::vector<std::string>{"small-gas",
                                                                               "small-bed"}),
                     code, case_name) {
    if (absent(code)) return;
    BOOST_CHECK(certify(case_name, code, [](Scene&) {}) == compare::Outcome::agree);
}

BOOST_DATA_TEST_CASE(a_defect_in_one_code_only_fails_the_certificate,
                     boost::unit_test::data::make(foreign_codes) *
                         boost::unit_test::data::make(defects()),
                     code, defect) {
    if (absent(code)) return;
    const auto& refused = defect.not_expressible_in;
    const bool expressible = std::find(refused.begin(), refused.end(), code) == refused.end();
    BOOST_CHECK(certify(defect.case_name, code, defect.plant) ==
                (expressible ? compare::Outcome::disagree : compare::Outcome::not_expressible));
}
