// The runs of one case, looked up by code, variant, time step and replica.
#pragma once

#include "adapters/run/store/store.hpp"
#include "cases/catalog/case.hpp"
#include "reference/compare/replicas.hpp"
#include "reference/compare/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::judge {

/// Why a code has no result: its verdicts get this outcome and reason.
struct Absence {
    compare::Outcome outcome = compare::Outcome::run_failed;
    std::string reason;
    std::string code;  ///< of a pair, which has none; else empty
};

class CaseRuns {
  public:
    CaseRuns(const catalog::Case& the_case, std::vector<store::RunRecord> records);

    [[nodiscard]] const catalog::Case& the_case() const noexcept { return *case_; }
    [[nodiscard]] const std::vector<store::RunRecord>& records() const noexcept { return records_; }
    /// Codes in the order of the records.
    [[nodiscard]] const std::vector<std::string>& codes() const noexcept { return codes_; }

    /// The successful run, or null.
    [[nodiscard]] const store::RunRecord* find(const std::string& code, std::size_t variant,
                                               std::size_t rung, std::int64_t replica) const;
    /// Set if any run of the code in this variant has no result.
    [[nodiscard]] std::optional<Absence> absence(const std::string& code,
                                                 std::size_t variant) const;
    /// One measurement from all replicas; nothing if a run failed or more than one in ten lack it.
    /// Setting replicas_without if some do.
    [[nodiscard]] std::optional<compare::Combined> combined(const std::string& code,
                                                            std::size_t variant, std::size_t rung,
                                                            const std::string& observable) const;
    /// Number of replicas of the code in this variant and rung.
    [[nodiscard]] std::int64_t replicas(const std::string& code, std::size_t variant,
                                        std::size_t rung) const;
    /// Whether the catalogue knows that the code cannot express the variant.
    [[nodiscard]] bool known_not_expressible(const std::string& code, std::size_t variant) const;

  private:
    const catalog::Case* case_;
    std::vector<store::RunRecord> records_;
    std::vector<std::string> codes_;
};

}  // namespace crossgrain::judge
