// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <array>
#include <map>
#include <utility>

#include "tests/bench/edit_measurement.hpp"
#include "tests/bench/markdown.hpp"
#include "tests/bench/path_measurement.hpp"
#include "tests/bench/sampling.hpp"
#include "tests/bench/targets.hpp"

namespace footfall::bench {
namespace {

class Report {
 public:
  explicit Report(const Json& results) : results_(results), threads_(results["threads"].back().get<int>()) {}

  std::string format() {
    if (!results_["paths"].empty()) return formatPaths(results_);
    if (!results_["crates"].empty()) return formatCrates(results_);
    if (!results_["reach"].empty()) return reach();
    std::string text = "Footfall " + results_["program"]["version"].get<std::string>() + ", at most " +
                       std::to_string(results_["runs"].get<int>()) + " runs after one warm-up, medians, ms.\n\n";
    if (!results_["targets"].empty()) text += "### Targets\n\n" + formatTargets(results_["targets"]);
    if (!results_["environments"].empty()) {
      text += "### Beside others, " + threadText() + "\n\n" + peers();
      if (results_["program"]["recast"].get<bool>()) text += "### Recast, its solo build\n\n" + recast();
      text += "### Step by step, " + threadText() + "\n\n" + steps();
      text += "### Threads, memory, exact fall-backs\n\n" + totals();
    }
    if (!results_["growth"].empty()) text += "### Growth, " + threadText() + "\n\n" + growth();
    if (!results_["cancelling"].empty()) text += "### Cancelling, " + threadText() + "\n\n" + cancelling();
    if (!results_["live"].empty()) text += "### Edits, " + threadText() + "\n\n" + edits();
    if (!results_["exports"].empty()) text += "### Exports, 1 thread\n\n" + exports();
    return text;
  }

 private:
  [[nodiscard]] std::string threadText() const { return bench::threadText(threads_); }

  std::string reach() const {
    const bool hasRecast = results_["program"]["recast"];
    std::vector<std::string> header{"environment", "as it is", "with steps", "components", "with steps", "links"};
    if (hasRecast)
      header.insert(header.end(), {"Recast", "common places", "ours", "Recast's", "only ours", "only Recast's"});
    Table table(header);
    std::string failures;
    const auto fails = [&](const std::string& name, const Json& entry) {
      failures += "- " + name + ": " + entry["fails"].get<std::string>() + '\n';
    };
    for (const Json& entry : results_["reach"]) {
      std::vector<std::string> row{entry["name"]};
      if (entry.contains("fails")) {
        fails(row[0], entry);
        row.resize(6, "fails");
      } else {
        row.insert(row.end(), {share(entry["plain"]["share"]), share(entry["steps"]["share"]),
                               grouped(entry["plain"]["components"]), grouped(entry["steps"]["components"]),
                               grouped(entry["links"])});
      }
      if (hasRecast) {
        const Json& theirs = entry["recast"];
        if (theirs.contains("fails")) {
          fails("Recast on " + row[0], theirs);
          row.push_back("fails");
          row.resize(header.size());
        } else {
          for (const char* figure : {"share", "common", "ours", "theirs", "only_ours", "only_theirs"})
            row.push_back(share(theirs[figure]));
        }
      }
      table.addRow(row);
    }
    return table.text() + (failures.empty() ? "" : "Fails:\n\n" + failures + '\n');
  }

  static std::string share(const Json& value) { return groupedWithDecimals(value, 3); }

  // "12.3 (0.45)": their time and ours over it.
  std::string against(const Json& peer, double ours, const std::string& key) {
    if (!peer.contains("wall_ms")) return "fails";
    const double theirs = peer["wall_ms"];
    ratios_[key].push_back(ours / theirs);
    return number(theirs) + " (" + number(ours / theirs) + ')';
  }

  std::string peers() {
    Table table({"environment", "triangles", "run, 1 thread", "run", "file to walkable", "prototype", "floor",
                 "Recast 0.3 m", "Recast 0.1 m", "Recast 0.05 m", "thesis, s"});
    for (const Json& environment : results_["environments"]) {
      const std::string name = environment["name"];
      const Json* own = atThreads(environment["footfall"], threads_);
      if (own == nullptr) {
        table.addRow({name, "", "", "fails: " + reasonOf(environment["footfall"]), "", "", "", "", "", "", ""});
        continue;
      }
      const double run = (*own)["run_ms"];
      const Json* single = atThreads(environment["footfall"], 1);
      std::vector<std::string> row{name, grouped((*own)["triangles"]),
                                   single == nullptr ? "-" : number((*single)["run_ms"]), number(run),
                                   number((*own)["file_to_walkable_ms"])};
      const Json* prototype =
          environment.contains("prototype") ? atThreads(environment["prototype"], threads_) : nullptr;
      row.push_back(prototype == nullptr ? "-" : against(*prototype, (*prototype)["ours_ms"], "prototype"));
      const Json* floor = environment.contains("floor") ? atThreads(environment["floor"], threads_) : nullptr;
      row.push_back(floor == nullptr ? "-" : against(*floor, run, "floor"));
      for (std::size_t i = 0; i < kCells; ++i) {
        row.push_back(environment.contains("recast") && single != nullptr
                          ? against(environment["recast"][i], (*single)["run_ms"], "recast" + std::to_string(i))
                          : "-");
      }
      row.push_back(environment.contains("thesis_s") ? thesis(environment["thesis_s"], run) : "-");
      table.addRow(row);
    }
    std::vector<std::string> means{"geometric mean", "", "", "", ""};
    for (const char* key : {"prototype", "floor", "recast0", "recast1", "recast2", "thesis"})
      means.push_back(ratios_[key].empty() ? "" : '(' + number(geometricMean(ratios_[key])) + ')');
    table.addRow(means);
    return table.text() +
           "In parentheses: our time over theirs (over Recast's, which has one thread, that on one thread), and for "
           "the "
           "thesis how many times faster we are. *run*: from the loaded environment to the navigation mesh, the "
           "default "
           "pipeline without steps.\n\n";
  }

  std::string recast() const {
    std::vector<std::string> header{"environment"};
    for (const char* cell : {"0.3 m", "0.1 m", "0.05 m"})
      header.insert(header.end(), {std::string(cell) + ": CPU", "MB", "area"});
    Table table(header);
    std::string failures;
    for (const Json& environment : results_["environments"]) {
      if (!environment.contains("recast")) continue;
      const std::string name = environment["name"];
      std::vector<std::string> row{name};
      for (const Json& entry : environment["recast"]) {
        if (entry.contains("fails")) {
          row.insert(row.end(), {"fails", "", ""});
          failures += "- " + name + " at " + number(entry["cell"]) + " m: " + entry["fails"].get<std::string>() + '\n';
          continue;
        }
        row.insert(row.end(), {number(entry["cpu_ms"]), megabytes(entry["peak_bytes"]),
                               entry.contains("area_percent") ? number(entry["area_percent"]) + " %" : "-"});
      }
      table.addRow(row);
    }
    return table.text() +
           "*MB*: what it takes at its peak. *area*: how much more than ours its area in the plan is.\n\n" +
           (failures.empty() ? "" : "Fails:\n\n" + failures + '\n');
  }

  std::string thesis(double seconds, double run) {
    ratios_["thesis"].push_back(1000 * seconds / run);
    return number(seconds) + " (" + grouped(1000 * seconds / run) + ')';
  }

  static std::string reasonOf(const Json& list) {
    for (const Json& entry : list)
      if (entry.contains("fails")) return entry["fails"];
    return "not measured";
  }

  std::string steps() const {
    std::vector<std::string> header{"environment", "load", "MB/s", "start", "tree in it"};
    std::string text;
    for (const Json& environment : results_["environments"]) {
      const Json* own = atThreads(environment["footfall"], threads_);
      if (own == nullptr) continue;
      if (text.empty()) {
        for (const Json& step : (*own)["steps"]) header.push_back(withoutFilter(step["name"]));
        header.insert(header.end(), {"navigation mesh", "export"});
        text = Table(header).text();
        text.pop_back();
      }
      std::vector<std::string> row{environment["name"]};
      for (const char* figure : {"load_ms", "load_mb_per_s", "start_ms", "tree_ms"})
        row.push_back(number((*own)[figure]));
      for (const Json& step : (*own)["steps"]) row.push_back(number(step["wall_ms"]));
      for (const char* figure : {"navigation_mesh_ms", "export_ms"}) row.push_back(number((*own)[figure]));
      text += '|';
      for (const std::string& cell : row) text += ' ' + cell + " |";
      text += '\n';
    }
    return text + '\n';
  }

  static std::string withoutFilter(const std::string& name) {
    const std::size_t ending = name.rfind("Filter");
    return ending == std::string::npos ? name : name.substr(0, ending);
  }

  std::string totals() const {
    std::vector<std::string> header{"environment"};
    for (const Json& threads : results_["threads"]) {
      const std::string count = std::to_string(threads.get<int>());
      header.insert(header.end(), {"run, " + count, "CPU, " + count, "peak MB, " + count});
    }
    for (const char* kind : kKinds) header.emplace_back(kind);
    Table table(header);
    for (const Json& environment : results_["environments"]) {
      std::vector<std::string> row{environment["name"]};
      const Json* last = nullptr;
      for (const Json& threads : results_["threads"]) {
        const Json* own = atThreads(environment["footfall"], threads);
        if (own == nullptr) {
          row.insert(row.end(), {"fails", "", ""});
          continue;
        }
        row.insert(row.end(),
                   {number((*own)["run_ms"]), number((*own)["run_cpu_ms"]), megabytes((*own)["peak_bytes"])});
        last = own;
      }
      for (const char* kind : kKinds)
        row.push_back(last == nullptr ? "" : grouped((*last)["exact_fallbacks_by_kind"][kind]));
      table.addRow(row);
    }
    return table.text();
  }

  std::string growth() const {
    Table table({"environment", "size", "triangles", "load", "run", "peak MB", "exponent of time", "of memory"});
    const Json exponents = growthExponents(results_);
    for (const Json& entry : results_["growth"]) {
      std::vector<std::string> row{entry["series"], grouped(entry["size"])};
      if (entry.contains("fails")) {
        row.insert(row.end(), {"", "", "fails: " + entry["fails"].get<std::string>(), "", "", ""});
      } else {
        row.insert(row.end(), {grouped(entry["triangles"]), number(entry["load_ms"]), number(entry["run_ms"]),
                               megabytes(entry["peak_bytes"])});
        std::array<std::string, 2> exponent;
        for (const Json& step : exponents)
          if (step["series"] == entry["series"] && step["to"] == entry["size"])
            exponent = {number(step["time"]), number(step["memory"])};
        row.insert(row.end(), exponent.begin(), exponent.end());
      }
      table.addRow(row);
    }
    return table.text();
  }

  std::string cancelling() const {
    Table table({"environment", "triangles", "load and run", "moments", "median", "longest", "in", "most CPU", "late"});
    for (const Json& entry : results_["cancelling"]) {
      if (entry.contains("fails")) {
        table.addRow({entry["name"], "", "fails: " + entry["fails"].get<std::string>(), "", "", "", "", "", ""});
        continue;
      }
      table.addRow({entry["name"], grouped(entry["triangles"]), number(entry["whole_ms"]), grouped(entry["moments"]),
                    number(entry["median_ms"]), number(entry["longest_ms"]), entry["longest_at"],
                    number(entry["longest_cpu_ms"]), grouped(static_cast<double>(entry["late"].size()))});
    }
    return table.text() +
           "From telling a run to stop until its caller knows, memory freed. *most CPU*: the most processor time of "
           "all "
           "threads in between. *late*: how many took longer than 50 ms.\n\n";
  }

  std::string edits() const {
    Table table({"environment", "triangles", "from nothing", "obstacle", "most", "slope", "clearance"});
    for (const Json& entry : results_["live"]) {
      std::vector<std::string> row{entry["name"]};
      if (entry.contains("fails")) {
        row.insert(row.end(), {"", "fails: " + entry["fails"].get<std::string>(), "", "", "", ""});
      } else {
        row.push_back(grouped(entry["triangles"]));
        for (const char* figure : {"full_ms", "obstacle_ms", "obstacle_most_ms", "slope_ms", "clearance_ms"})
          row.push_back(number(entry[figure]));
      }
      table.addRow(row);
    }
    return table.text() +
           "*obstacle*: from the call that moves 100 triangles to a random place of the walkable area to the "
           "navigation "
           "mesh; *slope*, *clearance*: the whole run after the slope went up by a degree, the clearance by 5 %. The "
           "results are those of a run from nothing, byte for byte.\n\n";
  }

  std::string exports() const {
    Table table({"format", "triangles", "made", "written", "MB"});
    for (const Json& entry : results_["exports"]) {
      if (entry.contains("fails")) {
        table.addRow({"", "", "fails: " + entry["fails"].get<std::string>(), "", ""});
        continue;
      }
      for (const Json& format : entry["formats"])
        table.addRow({"`" + format["ending"].get<std::string>() + "`", grouped(entry["triangles"]),
                      number(format["make_ms"]), number(format["write_ms"]),
                      number(format["bytes"].get<double>() / 1e6)});
    }
    return table.text() +
           "Of rough terrain in two layers, no two triangles in one plane. *made*: the bytes in memory; *written*: "
           "beside "
           "the target, down to the disk, and renamed.\n\n";
  }

  static constexpr std::size_t kCells = 3;
  static constexpr std::array<const char*, 6> kKinds{"slope", "height", "orientation", "side", "order", "area"};

  const Json& results_;
  int threads_;
  std::map<std::string, std::vector<double>> ratios_;
};

}  // namespace

std::string formatReport(const Json& results) { return Report(results).format(); }

std::string formatTargets(const Json& targets) {
  Table table({"against", "figure", "due", "measured", ""});
  for (const Json& target : targets) {
    const std::string unit = target["unit"].get<std::string>();
    const std::string ending = unit.empty() ? "" : ' ' + unit;
    const std::string where = target["where"].get<std::string>();
    table.addRow({target["against"], target["what"].get<std::string>() + (where.empty() ? "" : " (" + where + ')'),
                  (target["at_least"].get<bool>() ? "at least " : "at most ") + number(target["due"]) + ending,
                  target["measured"].is_null() ? "fails" : number(target["measured"]) + ending,
                  target["met"].get<bool>() ? "met" : "**missed**"});
  }
  return table.text();
}

}  // namespace footfall::bench
