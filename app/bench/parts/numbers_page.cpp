#include "app/bench/parts/numbers_page.h"

#include <fmt/format.h>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/comparison.h"

namespace fyd::bench {
namespace {

constexpr const char* kBeginning = R"(# Numbers

What each part costs and how far off it is, beside a baseline that was measured in the same run. One command makes this
page, its picture and the tables behind it (`resources/manual/numbers/numbers.csv`, all rows) on the machine that it names,
and puts the figures that the README quotes there too. It refuses a program that is not built of the present revision without
changes:

```sh
installer/numbers.sh
```

`fyd bench --all --out DIR` measures without touching the manual; `fyd bench step` one subject, with all of its columns. The
longest subjects have fewer or shorter cases here than alone, so that all of them together take minutes.

)";

constexpr const char* kReading = R"(## How to read it

A table has a line for each method. Where a subject has several cases (signals, networks, meshes), *rows* says how many, and the
other figures are medians over them; × baseline is the median of the ratios within each case, so below 1 is less than the
baseline. "—": there is none, or the case has no baseline. "never" counts as longer than any time, and has no multiple; "∞" is the
multiple of an error of nothing. Times are of one machine; ratios carry over to others
better than times do. What hands feel, and what real hardware does, is in none of these figures.

)";

std::string factsTable(const std::vector<Fact>& known) {
  Table facts{.subject = {},
              .title = {},
              .columns = {{"of this run", Role::group}, {"", Role::group}},
              .rows = {},
              .notes = {}};
  for (const Fact& fact : known) facts.rows.push_back({fact.name, fact.value});
  return markdownRows(facts);
}

}  // namespace

void writeNumbersPage(const std::vector<Table>& tables, const std::vector<Fact>& facts) {
  std::string page = kBeginning + factsTable(facts) + "\n";
  if (benchOptions().quick)
    page += "This run was shortened (`--quick`): its figures only show that each subject works.\n\n";
  if (const std::string picture = pictureOf(tables); !picture.empty()) {
    writeBeside("numbers.svg", picture);
    page +=
        "![Error against cost of the methods of each subject that has both, as multiples of the baseline, on "
        "logarithmic axes](images/numbers.svg)\n\nThe subjects that have both cost and error beside a baseline. To the "
        "right: cost; upward: error; both as multiples of the baseline (red), down to a thousandth and up to a "
        "thousandfold.\n\n";
  }
  page += kReading;
  for (const Table& table : tables) {
    const Table summary = summaryOf(table);
    page += fmt::format("## {}\n\n{}.\n\n{}", summary.subject, summary.title, markdownRows(summary));
    for (const std::string& note : summary.notes) page += fmt::format("\n{}\n", note);
    page += '\n';
  }
  page.pop_back();
  writeBeside("numbers.md", page);
  writeBeside("numbers.csv", toCsv(comparisonOf(tables)));
}

}  // namespace fyd::bench
