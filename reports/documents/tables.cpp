#include "reports/documents/tables.hpp"

#include "native/base/printable.hpp"
#include "reference/compare/parity.hpp"
#include "reports/documents/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace crossgrain::reports {
namespace {

using compare::Outcome;
using compare::Verdict;

std::string value_text(const measure::Measurement& m) {
    if (m.standard_error > 0) return fmt::format("{:.6g} +- {:.2g}", m.value, m.standard_error);
    return fmt::format("{:.8g}", m.value);
}

/// The finest time step of a ladder stands for it; the ladder itself is in the convergence checks.
std::string measurement_table(const judge::CaseReport& item) {
    const auto& codes = item.runs.codes();
    std::vector<std::string> header{"observable"};
    header.insert(header.end(), codes.begin(), codes.end());
    TextTable table(header);
    for (const auto& variant : item.the_case->variants) {
        std::vector<std::string> observables;
        std::map<std::pair<std::string, std::string>, std::string> cells;
        for (const auto& m : item.evaluation.measurements) {
            if (m.variant != variant.name || m.rung + 1 != variant.rungs) continue;
            const std::string& name = m.combined.measurement.observable;
            if (std::find(observables.begin(), observables.end(), name) == observables.end()) {
                observables.push_back(name);
            }
            cells[{name, m.code}] = value_text(m.combined.measurement);
        }
        for (const auto& name : observables) {
            std::vector<std::string> row{
                variant.name.empty() ? name : fmt::format("{} [{}]", name, variant.name)};
            for (const auto& code : codes) {
                const auto cell = cells.find({name, code});
                row.push_back(cell == cells.end() ? "-" : cell->second);
            }
            table.add(std::move(row));
        }
    }
    return table.empty() ? "" : table.text();
}

std::string counts_text(const std::vector<const Verdict*>& group) {
    std::map<Outcome, int> counts;
    for (const auto* v : group)
        ++counts[v->outcome];
    std::string text;
    for (const auto& [outcome, count] : counts) {
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : ", ", count, compare::to_string(outcome));
    }
    return text;
}

std::string worst_text(const std::vector<const Verdict*>& group) {
    const Verdict* worst = nullptr;
    for (const auto* v : group) {
        if (std::isnan(v->difference)) continue;
        if (worst == nullptr || std::abs(v->difference) > std::abs(worst->difference)) worst = v;
    }
    if (worst == nullptr) return "-";
    const std::string who = compare::is_pair(*worst)
                                ? fmt::format("{}, {}", worst->code, worst->against.name)
                                : worst->code;
    const std::string error =
        worst->uncertainty > 0 ? fmt::format(" +- {:.2g}", worst->uncertainty) : "";
    return fmt::format("{:.2g}{} of {:.2g} ({})", worst->difference, error, worst->limit, who);
}

std::string against_text(const Verdict& v) {
    return compare::is_pair(v) ? "pairs of codes" : compare::to_string(v.against);
}

std::string check_table(const judge::CaseReport& item) {
    TextTable table({"check", "kind", "setting", "against", "verdicts", "largest difference"});
    std::vector<std::string> order;
    std::map<std::string, std::vector<const Verdict*>> groups;
    for (const auto& v : item.evaluation.verdicts) {
        const std::string key =
            fmt::format("{}|{}|{}|{}", compare::observable_text(v), static_cast<int>(v.kind),
                        compare::setting_text(v), against_text(v));
        if (!groups.contains(key)) order.push_back(key);
        groups[key].push_back(&v);
    }
    for (const auto& key : order) {
        const auto& group = groups[key];
        const Verdict& first = *group.front();
        table.add({compare::observable_text(first), compare::to_string(first.kind),
                   compare::setting_text(first), against_text(first), counts_text(group),
                   worst_text(group)});
    }
    return table.empty() ? "" : table.text();
}

std::string finding_table(const judge::CaseReport& item) {
    TextTable table({"found", "code", "variant", "", ""});
    for (const auto& run : item.runs.records()) {
        if (run.replica != 0) continue;
        for (const auto& finding : run.results.findings)
            table.add({finding.name, run.code, run.variant, finding.label, finding.detail});
    }
    return table.empty() ? "" : table.text();
}

std::string cost_table(const judge::CaseReport& item) {
    TextTable table({"cost", "runs", "CPU s", "work per CPU s", ""});
    for (const auto& code : item.runs.codes()) {
        double cpu = 0;
        double work = 0;
        std::string unit;
        int count = 0;
        for (const auto& run : item.runs.records()) {
            if (run.code != code || run.status != store::RunStatus::ok) continue;
            cpu += run.cpu_s;
            work += run.work;
            unit = run.work_unit;
            ++count;
        }
        if (count == 0) continue;
        table.add({code, std::to_string(count), fmt::format("{:.2f}", cpu),
                   cpu > 0 ? fmt::format("{:.3g}", work / cpu) : "-", unit});
    }
    return table.empty() ? "" : table.text();
}

}  // namespace

std::string case_table(const judge::CaseReport& item) {
    return fmt::format("{}: {}\n{}\n{}\n{}\n{}\n", item.the_case->name, item.the_case->title,
                       measurement_table(item), finding_table(item), check_table(item),
                       cost_table(item));
}

std::string verdict_table(const session::SessionReport& report) {
    std::vector<std::string> codes;
    for (const auto& item : report.cases) {
        for (const auto& code : item.runs.codes()) {
            if (std::find(codes.begin(), codes.end(), code) == codes.end()) codes.push_back(code);
        }
    }
    std::vector<std::string> header{"verdicts"};
    header.insert(header.end(), codes.begin(), codes.end());
    TextTable table(header);
    for (const auto& item : report.cases) {
        std::vector<std::string> row{item.the_case->name};
        for (const auto& code : codes) {
            std::vector<const Verdict*> group;
            for (const auto& v : item.evaluation.verdicts) {
                if (v.code == code || (compare::is_pair(v) && v.against.name == code))
                    group.push_back(&v);
            }
            row.push_back(group.empty() ? "-" : counts_text(group));
        }
        table.add(std::move(row));
    }
    return table.text(0);
}

std::string certificate_table(const session::SessionReport& report) {
    TextTable table({"case", "codes", "max |dx| (digits) at contact times", "max |dh|", "verdict"});
    for (const auto& item : report.cases) {
        for (const auto& pair : item.evaluation.certificate) {
            std::vector<std::pair<double, double>> by_time;
            for (const auto& [time, dx] : pair.max_dx)
                by_time.emplace_back(std::stod(time), dx);
            std::sort(by_time.begin(), by_time.end());
            std::string dx_text;
            for (const auto& [time, dx] : by_time) {
                dx_text += fmt::format("{}{:g}: {:.1e} ({:.1f})", dx_text.empty() ? "" : "  ", time,
                                       dx, compare::matching_digits(dx, pair.diameter));
            }
            std::string dh_text;
            for (const auto& [window, dh] : pair.max_dh) {
                dh_text += fmt::format("{}t {}: {:.1e}", dh_text.empty() ? "" : "  ", window, dh);
            }
            table.add({pair.case_name, fmt::format("{}, {}", pair.a, pair.b),
                       dx_text.empty() ? "-" : dx_text, dh_text.empty() ? "-" : dh_text,
                       compare::to_string(pair.outcome)});
        }
    }
    return table.empty() ? "" : table.text(0);
}

namespace {

/// Reasons quote programs and files; of these a line says enough, --json says all.
std::string one_line(const std::string& reason) {
    constexpr std::size_t longest = 1000;
    return printable(reason, longest);
}

}  // namespace

std::string question_text(const compare::Verdict& v) {
    const std::string setting = compare::setting_text(v), against = compare::to_string(v.against);
    return fmt::format("{} {}{}{}", compare::observable_text(v),
                       setting.empty() ? "" : fmt::format("[{}] ", setting), v.code,
                       against.empty() ? "" : " against " + against);
}

std::string exceptions_list(const session::SessionReport& report) {
    std::string text;
    for (const auto& item : report.cases) {
        std::set<std::string> failures;
        for (const auto& run : item.runs.records()) {
            if (store::has_failed(run.status)) failures.insert(run.reason);
        }
        for (const auto& reason : failures) {
            text += fmt::format("run_failed: {}: {}\n", item.the_case->name, one_line(reason));
        }
        for (const auto& v : item.evaluation.verdicts) {
            if (v.expected || v.outcome == Outcome::run_failed) continue;
            text += fmt::format("{}: {} {}: {}\n", compare::to_string(v.outcome),
                                item.the_case->name, question_text(v), one_line(v.reason));
        }
    }
    return text;
}

}  // namespace crossgrain::reports
