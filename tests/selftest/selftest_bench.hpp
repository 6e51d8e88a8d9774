// Where the trials of a selftest are set up: all runs of all trials are planned first, carried out
// together (side by side, with one progress line), and looked up again for each trial.
#pragma once

#include "adapters/run/plan.hpp"
#include "adapters/run/store/store.hpp"
#include "tests/selftest/selftest_catalogue.hpp"
#include "tests/selftest/selftest_defective_code.hpp"

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::selftest {

/// Runs of one code in one case, under the name by which verdicts know them.
struct RunSlice {
    std::size_t first = 0, count = 0;
    std::string label;
};

class SelftestBench {
  public:
    /// Edited files live below settings.results, as long as this.
    explicit SelftestBench(const run::Settings& settings);
    ~SelftestBench();
    SelftestBench(const SelftestBench&) = delete;
    SelftestBench& operator=(const SelftestBench&) = delete;

    /// The case, of the catalogue or by path, read once and kept. Throws CaseError.
    [[nodiscard]] const catalog::Case& find_case(const std::string& name);
    /// The case with a text of its file replaced.
    [[nodiscard]] const catalog::Case& edited_case(const std::string& name, const TextEdit& edit,
                                                   const std::string& place);
    /// The case with a text of a reading replaced, which keeps its name.
    [[nodiscard]] const catalog::Case& case_with_reading(const std::string& name,
                                                         const std::string& reading,
                                                         const TextEdit& edit,
                                                         const std::string& place);
    /// A copy of the published values with a text of a file replaced; an empty `from` empties it.
    [[nodiscard]] std::filesystem::path
    edited_references(const std::string& file, const TextEdit& edit, const std::string& place);

    [[nodiscard]] RunSlice plan_runs(const catalog::Case& the_case, const adapters::Code& code,
                                     std::uint64_t seed, std::string label);
    /// The same with a defect in `code`. Throws CaseError if it cannot express it.
    [[nodiscard]] RunSlice plan_defective(const catalog::Case& the_case, const adapters::Code& code,
                                          const Defect& defect, const catalog::Case& changed);

    void carry_out(const std::stop_token& stop);
    [[nodiscard]] bool interrupted() const noexcept { return interrupted_; }
    /// After carry_out: the slice's records under its label.
    [[nodiscard]] std::vector<store::RunRecord> records(const RunSlice& slice) const;

    static constexpr std::uint64_t first_seed = 1;

  private:
    [[nodiscard]] std::filesystem::path new_directory();
    const catalog::Case& keep(catalog::Case the_case);

    run::Settings settings_;
    std::filesystem::path workspace_;
    int directories_ = 0;
    std::vector<std::unique_ptr<const catalog::Case>> cases_;
    std::map<std::string, const catalog::Case*> by_name_;
    std::vector<std::unique_ptr<adapters::Code>> defective_codes_;
    std::vector<run::PlannedRun> planned_;
    std::vector<store::RunRecord> records_;
    bool interrupted_ = false;
};

}  // namespace crossgrain::selftest
