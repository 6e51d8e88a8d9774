// Protects the tables of models against molecular dynamics and the fits over variants. The runs are
// made up, so that every answer is known.
#include "reports/studies/models/models_table.hpp"

#include "native/base/errors.hpp"

#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace crossgrain;
using compare::Outcome;

namespace {

/// The made-up case has the steps 0.001 and 0.002, which serve as abscissa.
std::shared_ptr<const catalog::Case> sweep(std::vector<catalog::Fit> fits = {}) {
    auto one = std::make_shared<catalog::Case>(catalog::load_case(
        CROSSGRAIN_SOURCE_DIR "/tests/app/cases/small-sweep.toml", catalog::Suite::full));
    one->fits = std::move(fits);
    return one;
}

store::RunRecord run_of(const std::string& code, const std::string& variant, double value,
                        double error, const std::string& label = "wave") {
    store::RunRecord record{.case_name = "small-sweep",
                            .variant = variant,
                            .code = code,
                            .seed = 1,
                            .status = store::RunStatus::ok};
    record.results.measurements = {
        {.observable = "ratio", .value = value, .standard_error = error, .n = 20},
        {.observable = "half", .value = 2, .standard_error = 0.02, .n = 20}};
    record.results.findings = {{.name = "wave", .label = label, .detail = ""}};
    return record;
}

const std::string first = "verlet-half-step/dt=0.001", second = "verlet-half-step/dt=0.002";

const published::PublishedValues& literature() {
    static const tests::TemporaryDirectory directory;
    static const published::PublishedValues values = [] {
        std::ofstream(directory.path() / "test.toml")
            << "source = \"a test\"\n[value.number]\nquantity = \"ratio\"\nvalue = 1.4\nerror = "
               "0.0\nplace = \"here\"\nobtained = \"made up\"\n";
        return published::PublishedValues(directory.path());
    }();
    return values;
}

judge::CaseReport report_of(std::vector<store::RunRecord> records,
                            std::vector<catalog::Fit> fits = {}) {
    const auto the_case = sweep(std::move(fits));
    judge::CaseRuns runs(*the_case, std::move(records));
    auto evaluation = judge::evaluate(runs, literature());
    return {the_case, std::move(runs), std::move(evaluation)};
}

studies::Phenomenon phenomenon(const std::string& rows) {
    static const tests::TemporaryDirectory directory;
    const auto file = directory.path() / "pipe.toml";
    std::ofstream(file) << R"(title = "a test"
text = "made up"
reference = "a"
[[column]]
name = "a"
title = "code a"
group = "grains"
code = "a"
case = "small-sweep"
variant = "verlet-half-step/dt=0.001"
[[column]]
name = "b"
title = "code b"
group = "grains"
code = "b"
case = "small-sweep"
variant = "verlet-half-step/dt=0.001"
[[column]]
name = "book"
title = "literature"
)" << rows;
    return studies::load_phenomenon(file);
}

studies::FilledRow filled(const std::string& row, const std::vector<store::RunRecord>& records,
                          std::vector<catalog::Fit> fits = {}) {
    std::vector<judge::CaseReport> cases;
    cases.push_back(report_of(records, std::move(fits)));
    return studies::fill(phenomenon("[[row]]\nquantity = \"q\"\nreason = \"test\"\n" + row), cases,
                         literature())
        .rows.at(0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(cells_are_judged_against_the_reference) {
    const std::string row = "margin = 0.1\nvalue = { grains = \"ratio\", book = "
                            "\"published:test/number\" }\n";
    const auto same = filled(row, {run_of("a", first, 1.37, 0.01), run_of("b", first, 1.38, 0.01)});
    BOOST_CHECK(same.outcome == Outcome::agree);
    BOOST_TEST(!same.cells[0].outcome);  // the reference itself
    BOOST_CHECK(same.cells[1].outcome == Outcome::agree);
    BOOST_CHECK(same.cells[2].outcome == Outcome::agree);
    const auto other = filled(row, {run_of("a", first, 1.37, 0.01), run_of("b", first, 1.9, 0.01)});
    BOOST_CHECK(other.outcome == Outcome::disagree);
    BOOST_CHECK(other.cells[2].outcome == Outcome::agree);
    const auto unsure = filled(row, {run_of("a", first, 1.37, 0.01), run_of("b", first, 1.4, 0.2)});
    BOOST_CHECK(unsure.outcome == Outcome::undecided);
}

BOOST_AUTO_TEST_CASE(what_has_not_run_is_never_green) {
    const std::string row = "margin = 0.1\nvalue = { grains = \"ratio\" }\n";
    auto only_reference = filled(row, {run_of("a", first, 1.37, 0.01)});
    BOOST_CHECK(only_reference.outcome == Outcome::no_reference);
    BOOST_CHECK(only_reference.cells[1].kind == studies::TableCell::Kind::absent);
    const auto no_reference = filled(row, {run_of("b", first, 1.37, 0.01)});
    BOOST_CHECK(no_reference.outcome == Outcome::no_reference);
    BOOST_TEST(!no_reference.cells[1].outcome);
    const auto nothing = studies::fill(
        phenomenon("[[row]]\nquantity = \"q\"\nreason = \"test\"\n" + row), {}, literature());
    BOOST_CHECK(nothing.rows[0].outcome == Outcome::no_reference);
    auto failed = run_of("b", first, 1.37, 0.01);
    failed.status = store::RunStatus::run_failed;
    failed.reason = "it broke";
    const auto broken = filled(row, {run_of("a", first, 1.37, 0.01), failed});
    BOOST_TEST(broken.cells[1].reason == "it broke");
    BOOST_CHECK(broken.outcome == Outcome::no_reference);
    const auto unmeasured =
        filled("margin = 0.1\nvalue = { grains = \"other\" }\n", {run_of("a", first, 1, 0)});
    BOOST_TEST(unmeasured.cells[0].reason == "'other' was not measured");
    BOOST_TEST(unmeasured.cells[0].measured_nothing);
    BOOST_TEST(!broken.cells[1].measured_nothing);
}

BOOST_AUTO_TEST_CASE(quotients_carry_their_errors) {
    const auto row =
        filled("margin = 0.1\nvalue = { a = \"ratio / half\" }\n", {run_of("a", first, 1.0, 0.01)});
    BOOST_TEST(row.cells[0].value == 0.5);
    BOOST_TEST(row.cells[0].standard_error == std::hypot(0.005, 0.005),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(signs_and_words) {
    const std::string sign = "judge = \"sign\"\nvalue = { grains = \"ratio\" }\n";
    const auto of = [&](double value, double error) {
        return filled(sign, {run_of("a", first, 1, 0.1), run_of("b", first, value, error)}).outcome;
    };
    BOOST_CHECK(of(0.5, 0.1) == Outcome::agree);
    BOOST_CHECK(of(-0.5, 0.1) == Outcome::disagree);
    BOOST_CHECK(of(0.1, 0.1) == Outcome::undecided);
    const std::string word = "judge = \"word\"\nagainst = \"book\"\nvalue = { grains = "
                             "\"finding:wave\", book = \"word:wave\" }\n";
    const auto row =
        filled(word, {run_of("a", first, 1, 0.1), run_of("b", first, 1, 0.1, "carried")});
    BOOST_CHECK(row.cells[0].outcome == Outcome::agree);
    BOOST_CHECK(row.cells[1].outcome == Outcome::disagree);
    BOOST_TEST(row.cells[1].reason == "carried, not wave");
}

BOOST_AUTO_TEST_CASE(a_word_needs_two_thirds_of_the_runs) {
    const std::string word = "judge = \"word\"\nagainst = \"book\"\nvalue = { grains = "
                             "\"finding:wave\", book = \"word:wave\" }\n";
    const auto of = [&](const std::vector<std::string>& labels) {
        std::vector<store::RunRecord> runs;
        for (const auto& label : labels) {
            runs.push_back(run_of("a", first, 1, 0.1, label));
            runs.back().replica = static_cast<std::int64_t>(runs.size()) - 1;
        }
        return filled(word, runs).cells[0];
    };
    BOOST_CHECK(of({"wave", "wave", "carried"}).outcome == Outcome::agree);
    BOOST_TEST(of({"wave", "wave", "carried"}).reason ==
               "carried in 1 of 3 runs, wave in 2 of 3 runs");
    BOOST_CHECK(of({"carried", "wave", "carried"}).outcome == Outcome::disagree);
    BOOST_CHECK(of({"wave", "carried"}).outcome == Outcome::undecided);
    BOOST_CHECK(of({"undecided"}).outcome == Outcome::undecided);
}

BOOST_AUTO_TEST_CASE(a_column_may_differ_from_its_group_in_the_variant_only) {
    const auto row = filled("margin = 0.1\nvalue = { grains = \"ratio\" }\nvariant = { b = \"" +
                                second + "\" }\n",
                            {run_of("a", first, 1.0, 0.01), run_of("b", second, 2.0, 0.01)});
    BOOST_TEST(row.cells[1].value == 2.0);
    BOOST_CHECK(row.outcome == Outcome::disagree);
}

BOOST_AUTO_TEST_CASE(files_that_make_no_sense_are_refused) {
    const auto refuse = [](const std::string& row) {
        BOOST_CHECK_THROW((void)phenomenon("[[row]]\nquantity = \"q\"\nreason = \"r\"\n" + row),
                          CaseError);
    };
    refuse("margin = 0.1\nvalue = { nobody = \"ratio\" }\n");
    refuse("margin = 0.1\nagainst = \"nobody\"\nvalue = { a = \"ratio\" }\n");
    refuse("margin = 0.1\nvalue = { a = \"ratio\" }\nvariant = { book = \"x\" }\n");
    refuse("value = { a = \"ratio\" }\n");  // no margin
    refuse("margin = 0.1\nvalue = { a = \"ratio\" }\nmargins = 0.2\n");
}

BOOST_AUTO_TEST_CASE(text_and_json_say_the_same) {
    std::vector<judge::CaseReport> cases;
    cases.push_back(report_of({run_of("a", first, 1.37, 0.01), run_of("b", first, 1.9, 0.01)}));
    const auto table =
        studies::fill(phenomenon("[[row]]\nquantity = \"V_w/V\"\nreason = \"test\"\nmargin = 0.1\n"
                                 "value = { grains = \"ratio\" }\nleft_out = \"much\"\n"),
                      cases, literature());
    const std::string text = studies::text_of(table);
    BOOST_TEST(text.find("1.37 +- 0.01 (ref)") != std::string::npos);
    BOOST_TEST(text.find("1.9 +- 0.01 (!)") != std::string::npos);
    BOOST_TEST(text.find("V_w/V: much") != std::string::npos);
    const auto json = studies::json_of(table);
    BOOST_TEST(json.at("rows").at(0).at("verdict") == "disagree");
    BOOST_TEST(json.at("rows").at(0).at("cells").at(1).at("value") == 1.9);
}

BOOST_AUTO_TEST_CASE(figures_hold_the_mean_of_series_and_measurements_over_a_sweep) {
    const auto run = [](std::int64_t replica, double y, double last_x = 2) {
        auto record = run_of("a", first, 1.3 + y, 0.1);
        record.replica = replica;
        record.results.series = {{.name = "wall",
                                  .columns = {"x", "y", "iteration"},
                                  .values = {{1, last_x, 1}, {y, 2 * y, 9}, {100, 100, 50}}}};
        return record;
    };
    const auto figures = [](std::vector<store::RunRecord> records) {
        std::vector<judge::CaseReport> cases;
        cases.push_back(report_of(std::move(records)));
        const auto one = phenomenon(R"([[figure]]
title = "t"
x = "x axis"
y = "y axis"
curve = [
  { title = "series", case = "small-sweep", code = "a", variant = "verlet-half-step/dt=0.001", series = "wall", x = "x", y = "y", where = { iteration = 100 } },
  { title = "sweep", case = "small-sweep", code = "a", observable = "ratio", along = "dt" },
  { title = "not run", case = "small-sweep", code = "b", observable = "ratio", along = "dt" },
]
)");
        return studies::fill_figures(one, cases);
    };
    auto other = run_of("a", second, 1.7, 0.1);
    auto more = other;
    more.replica = 1;
    const auto found = figures({run(0, 3), run(1, 5), other, more});
    BOOST_TEST_REQUIRE(found.size() == 1U);
    BOOST_TEST_REQUIRE(found[0].curves.size() == 2U);  // code b has no points
    const auto& series = found[0].curves[0];
    BOOST_TEST(series.x == (std::vector<double>{1, 2}), boost::test_tools::per_element());
    BOOST_TEST(series.y == (std::vector<double>{4, 8}), boost::test_tools::per_element());
    BOOST_TEST(series.standard_error == (std::vector<double>{1, 2}),
               boost::test_tools::per_element());
    const auto& over_sweep = found[0].curves[1];
    BOOST_TEST(over_sweep.x == (std::vector<double>{0.001, 0.002}),
               boost::test_tools::per_element());
    BOOST_TEST(over_sweep.y[1] == 1.7);
    // Replicas with other abscissas are no mean; the first one stands.
    const auto unlike = figures({run(0, 3), run(1, 5, 7), other, more});
    BOOST_TEST(unlike[0].curves[0].y == (std::vector<double>{3, 6}),
               boost::test_tools::per_element());
    BOOST_TEST(figures({run_of("c", first, 1, 1)}).empty());
}

BOOST_AUTO_TEST_CASE(fits_over_variants_are_measurements_of_the_case) {
    // Four steps would be needed for most laws; three points of an exact power law here.
    auto the_case = std::make_shared<catalog::Case>(*sweep());
    the_case->fits = {{.name = "power",
                       .law = catalog::FitLaw::inverse_exponent,
                       .observable = "ratio",
                       .along = "angle",
                       .from = 1.0},
                      {.name = "slope",
                       .law = catalog::FitLaw::local_slope,
                       .observable = "ratio",
                       .along = "angle"},
                      {.name = "few",
                       .law = catalog::FitLaw::exponent,
                       .observable = "ratio",
                       .along = "angle",
                       .from = 3.0}};
    std::vector<store::RunRecord> records;
    double angle = 1;
    for (const auto& variant : the_case->variants) {
        auto record = run_of("a", variant.name, 7 / (angle * angle), 0);
        record.results.measurements[0].settings = {{"angle", angle}};
        records.push_back(record);
        angle *= 2;  // 1, 2, 4, 8
    }
    const judge::CaseRuns runs(*the_case, std::move(records));
    const auto evaluation = judge::evaluate(runs, literature());
    std::size_t slopes = 0;
    for (const auto& m : evaluation.measurements) {
        const auto& measured = m.combined.measurement;
        if (measured.observable == "power") {
            BOOST_TEST(measured.value == 2.0, boost::test_tools::tolerance(1e-9));
            BOOST_TEST(m.variant.empty());
            BOOST_TEST(measured.settings.at("points") == 4.0);
            BOOST_TEST(measured.settings.at("to") == 8.0);
        }
        slopes += measured.observable == "slope" ? 1 : 0;
        BOOST_TEST(measured.observable != "few");
    }
    BOOST_TEST(slopes == 2U);  // the inner variants
}

BOOST_AUTO_TEST_CASE(the_phenomena_that_ship_name_cases_variants_and_references_that_exist) {
    const std::filesystem::path catalog_directory = CROSSGRAIN_SOURCE_DIR "/cases/catalog";
    const published::PublishedValues shipped(CROSSGRAIN_SOURCE_DIR "/reference/published");
    const auto names = studies::phenomenon_names(catalog_directory / "phenomena");
    BOOST_TEST(names.size() == 2U);
    for (const auto& name : names) {
        const auto one =
            studies::load_phenomenon(catalog_directory / "phenomena" / (name + ".toml"));
        std::map<std::string, catalog::Case> cases;
        for (const auto& needed : one.cases()) {
            cases.emplace(needed, catalog::find_case(catalog_directory.string(), needed,
                                                     catalog::Suite::full));
        }
        for (const auto& figure : one.figures) {
            for (const auto& curve : figure.curves) {
                if (curve.series.empty()) continue;
                BOOST_TEST(std::ranges::count(cases.at(curve.case_name).variants, curve.variant,
                                              &catalog::Variant::name) == 1,
                           curve.case_name << " has no variant " << curve.variant);
            }
        }
        for (const auto& row : one.rows) {
            for (const auto& column : one.columns) {
                const auto* source = studies::Phenomenon::source(row, column);
                if (source == nullptr) continue;
                if (source->value.starts_with("published:")) {
                    BOOST_TEST(shipped.find(source->value.substr(10)).has_value(), source->value);
                }
                if (column.code.empty()) continue;
                const auto& owner = cases.at(source->case_name.value_or(column.case_name));
                const std::string variant = source->variant.value_or(column.variant);
                BOOST_TEST(std::ranges::count(owner.variants, variant, &catalog::Variant::name) ==
                               1,
                           owner.name << " has no variant " << variant);
            }
        }
    }
}
