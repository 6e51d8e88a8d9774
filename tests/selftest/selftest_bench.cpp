#include "tests/selftest/selftest_bench.hpp"

#include "adapters/run/case_names.hpp"

#include "native/base/share_directory.hpp"

#include "adapters/registry/codes.hpp"

#include "adapters/run/runner.hpp"
#include "native/base/errors.hpp"
#include "reports/documents/atomic_file.hpp"
#include "reports/session/session.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace crossgrain::selftest {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file, const std::string& place) {
    std::ifstream in(file, std::ios::binary);
    if (!in) {
        throw CaseError({.file = place,
                         .problem = "is about a file that cannot be read",
                         .got = file.string(),
                         .expected = "a file that comes with the program"});
    }
    return {std::istreambuf_iterator<char>(in), {}};
}

void edit_file(const fs::path& file, const TextEdit& edit, const std::string& place) {
    reports::write_file_atomically(file, edited(text_of(file, place), edit, place));
}

/// Throws for a filter that the model of this scene does not know.
void require_filter(const Defect& defect, const scene::AnyScene& scene) {
    if (defect.kind != DefectKind::frames) return;
    std::visit(
        [&](const auto& s) {
            using Frame = typename scene::FrameOf<std::decay_t<decltype(s)>>::type;
            (void)frame_filter(
                defect.filter, s, [](const Frame&) {}, defect.place);
        },
        scene);
}

}  // namespace

SelftestBench::SelftestBench(const run::Settings& settings)
    : settings_(settings), workspace_(settings.results / "edited") {
    fs::remove_all(workspace_);
}

SelftestBench::~SelftestBench() {
    std::error_code ignored;  // left-overs do no harm
    fs::remove_all(workspace_, ignored);
}

fs::path SelftestBench::new_directory() {
    const fs::path directory = workspace_ / std::to_string(++directories_);
    fs::create_directories(directory);
    return directory;
}

const catalog::Case& SelftestBench::keep(catalog::Case the_case) {
    run::check_names(the_case);
    cases_.push_back(std::make_unique<const catalog::Case>(std::move(the_case)));
    return *cases_.back();
}

const catalog::Case& SelftestBench::find_case(const std::string& name) {
    auto& known = by_name_[name];
    if (known == nullptr) {
        const std::string directory = (share_directory() / "catalog").string();
        known = &keep(catalog::find_case(directory, name, catalog::Suite::quick));
    }
    return *known;
}

const catalog::Case& SelftestBench::edited_case(const std::string& name, const TextEdit& edit,
                                                const std::string& place) {
    const fs::path file = new_directory() / fs::path(find_case(name).file).filename();
    fs::copy_file(find_case(name).file, file);
    edit_file(file, edit, place);
    return keep(catalog::load_case(file.string(), catalog::Suite::quick,
                                   (share_directory() / "catalog/readings").string()));
}

const catalog::Case& SelftestBench::case_with_reading(const std::string& name,
                                                      const std::string& reading,
                                                      const TextEdit& edit,
                                                      const std::string& place) {
    const fs::path readings = new_directory();
    fs::copy(share_directory() / "catalog/readings", readings);
    edit_file(readings / reading, edit, place);
    return keep(catalog::load_case(find_case(name).file, catalog::Suite::quick, readings.string()));
}

fs::path SelftestBench::edited_references(const std::string& file, const TextEdit& edit,
                                          const std::string& place) {
    const fs::path directory = new_directory();
    fs::copy(share_directory() / "published", directory);
    edit_file(directory / file, edit, place);
    return directory;
}

RunSlice SelftestBench::plan_runs(const catalog::Case& the_case, const adapters::Code& code,
                                  std::uint64_t seed, std::string label) {
    run::Settings own = settings_;
    own.seed = seed;
    const std::size_t first = planned_.size();
    for (auto& run : run::plan(the_case, {&code}, own)) {
        run.mark = std::to_string(first);
        planned_.push_back(std::move(run));
    }
    return {first, planned_.size() - first, std::move(label)};
}

RunSlice SelftestBench::plan_defective(const catalog::Case& the_case, const adapters::Code& code,
                                       const Defect& defect, const catalog::Case& changed) {
    const adapters::Code& runs = defect.kind == DefectKind::borrowed
                                     ? *adapters::select_codes({defect.lender}).front()
                                     : code;
    require_filter(defect, the_case.scene(0, 0, first_seed));
    ScenePairs scenes;
    if (&changed != &the_case) {
        scenes = ScenePairs(the_case, changed, first_seed, the_case.replicas.of(code.name()),
                            defect.place);
    }
    defective_codes_.push_back(
        make_defective(code, runs, defect, std::move(scenes), the_case.model));
    const RunSlice slice = plan_runs(the_case, *defective_codes_.back(), first_seed, code.name());
    for (std::size_t i = slice.first; i < slice.first + slice.count; ++i) {
        if (planned_[i].record.status == store::RunStatus::planned) continue;
        throw CaseError({.file = defect.place,
                         .key = defect.name,
                         .problem = fmt::format("cannot be planted in {}", code.name()),
                         .got = planned_[i].record.reason,
                         .expected = "a scene that the code can express"});
    }
    return slice;
}

void SelftestBench::carry_out(const std::stop_token& stop) {
    store::Store store = session::open_store(settings_, store::Access::write_later);
    run::RunSummary summary = run::carry_out(std::move(planned_), store, settings_, stop, true);
    records_ = std::move(summary.records);
    interrupted_ = summary.interrupted;
}

std::vector<store::RunRecord> SelftestBench::records(const RunSlice& slice) const {
    const auto first = records_.begin() + static_cast<std::ptrdiff_t>(slice.first);
    std::vector<store::RunRecord> found(first, first + static_cast<std::ptrdiff_t>(slice.count));
    for (auto& record : found)
        record.code = slice.label;
    return found;
}

}  // namespace crossgrain::selftest
