#include <chrono>
#include <fstream>
#include <iterator>

#include "proto/words/numbers/fixed_text.h"
#include "support/program/ending.h"
#include "support/program/files/whole_file.h"
#include "support/program/log.h"
#include "tools/study/commands.h"
#include "tools/study/progress.h"
#include "tools/study/search/judgement_file.h"
#include "tools/study/search/search_page.h"

namespace telepalp::study {
namespace {

const program::Usage kSearchUsage{
    .program = "telepalp-study search",
    .purpose =
        "looks for the four-bar linkage with which a needle overshoots least, and for the best one within each "
        "of several bounds on the hand's force; other operators judge the best again. MIN:MAX is in mm or "
        "rad; one number fixes a parameter. Without the option: S4's Table 1, in brackets",
    .positional = "",
    .options = {{"l1", "MIN:MAX", "length of link 1 (80:120)"},
                {"l2", "MIN:MAX", "length of link 2 (100:150)"},
                {"l3", "MIN:MAX", "length of link 3 (80:120)"},
                {"l4", "MIN:MAX", "length of link 4 (drawn for each operator)"},
                {"theta", "MIN:MAX", "angle of the needle to link 2 (-0.31:0.31)"},
                {"phi", "MIN:MAX", "angle of the handle to link 3 (0:2.618)"},
                {"h", "MIN:MAX", "place of the handle on link 3 (0:80)"},
                {"l_h", "MIN:MAX", "length of the handle (140:180)"},
                {"needle", "MIN:MAX", "length of the needle (drawn for each operator)"},
                {"box", "FILE", "the same, one in each line: l1=80:120; options come later"},
                {"evaluations", "N", "mechanisms to judge, S4's 36 included", "300"},
                {"operators", "N", "who judge each mechanism", "12"},
                {"held-out", "N", "other operators, who judge the best again", "36"},
                {"penetrations", "N", "of each mechanism by each operator", "3"},
                kSeedOption,
                kThreadsOption,
                {"out", "DIR", "folder of report.html, search.json and evaluations.csv; the same command resumes",
                 "search"},
                {"json", "", "print search.json instead of the table"}},
    .example = "telepalp-study search --phi 0:1.57 --evaluations 100 --out search",
};

Result<SearchBox> read_box(const program::Arguments& arguments) {
  SearchBox box = paper_box();
  if (const std::string file = arguments.text("box"); !file.empty()) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
      return Error{.what = "cannot be read", .where = file, .fix = "give a text file with lines such as l1=80:120"};
    Result<SearchBox> read = parse_box(std::move(box), {std::istreambuf_iterator<char>(in), {}}, file);
    if (!read) return read.error();
    box = std::move(*read);
  }
  for (const MechanismParameter& one : mechanism_parameters())
    if (const std::string given = arguments.text(one.name); !given.empty())
      if (const auto set = set_range(box, one.name, given, "--" + std::string(one.name)); !set) return set.error();
  return checked(box);
}

struct Choice {
  SearchBox box;
  SearchSettings settings;
  std::filesystem::path out;
};

Result<Choice> read_search_options(const program::Arguments& arguments) {
  Result<SearchBox> box = read_box(arguments);
  if (!box) return box.error();
  const Result<RunChoice> run = read_run_choice(arguments);
  if (!run) return run.error();
  Choice choice{.box = std::move(*box), .settings = {.seed = run->seed, .threads = run->threads}, .out = run->out};
  struct Number {
    const char* option;
    int SearchSettings::*value;
    std::int64_t least;
    std::int64_t most;
  };
  for (const Number& one : {Number{"evaluations", &SearchSettings::evaluations, kLeastEvaluations, 100'000},
                            Number{"operators", &SearchSettings::operators, 1, 1000},
                            Number{"held-out", &SearchSettings::held_out, 1, 1000},
                            Number{"penetrations", &SearchSettings::penetrations, 1, 50}}) {
    const Result<std::int64_t> number = arguments.whole(one.option, one.least, one.most);
    if (!number) return number.error();
    choice.settings.*one.value = static_cast<int>(*number);
  }
  return choice;
}

/// Shows how far the search is, and the time that is left at the pace so far.
class Teller {
 public:
  void tell(const SearchState& state) {
    if (state.done <= 1) restart(state.done);  // before the first judgement, the operators are made
    line_.show(words(state), state.done, state.total);
  }
  /// The judgements so far came from a file: they do not count for the pace.
  void restart(int done) {
    begin_ = Clock::now();
    begun_at_ = done;
  }

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::string words(const SearchState& state) const {
    std::string text = std::to_string(state.done) + " of " + std::to_string(state.total) +
                       (state.held_out ? " of the best judged again" : " mechanisms judged");
    const double spent_s = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (const int judged = state.done - begun_at_; judged > 0 && state.done < state.total)
      text += ", about " + fixed_text(spent_s / judged * (state.total - state.done), 0) + " s left";
    if (state.best) text += "; least overshoot " + fixed_text(state.best->searched.overshoot_mm.mean, 2) + " mm";
    return text;
  }

  ProgressLine line_;
  Clock::time_point begin_ = Clock::now();
  int begun_at_ = 0;
};

Result<SearchResult> run(const Choice& choice) {
  Result<std::unique_ptr<JudgementFile>> file = JudgementFile::open(choice.out, choice.settings);
  if (!file) return file.error();
  if ((*file)->found() > 0)
    program::log("telepalp-study",
                 std::to_string((*file)->found()) + " mechanisms were judged before, and are not judged again");
  program::say_when_stopped("\ntelepalp-study: stopped: judged mechanisms are kept in " + (*file)->path().string() +
                            "; the same command resumes");
  SearchSettings settings = choice.settings;
  settings.store = file->get();
  Teller teller;
  int known = (*file)->found();
  Result<SearchResult> result = search_designs(choice.box, settings, [&](const SearchState& state) {
    if (known > 0 && state.done <= known && !state.held_out) teller.restart(state.done);
    teller.tell(state);
  });
  if (!result) return result.error();
  if (const Result<void> written = (*file)->written(); !written) return written.error();
  for (const auto& [name, text] :
       {std::pair<const char*, std::string>{"search.json", search_json(choice.box, choice.settings, *result)},
        {"report.html", search_html(choice.box, choice.settings, *result)}})
    if (const auto written = program::write_whole_file(choice.out / name, text, program::Readers::Anyone); !written)
      return written.error();
  return result;
}

}  // namespace

int run_search(int argc, const char* const* argv) {
  return program::run_program(kSearchUsage, argc, argv, [](const program::Arguments& arguments) {
    const Result<Choice> choice = read_search_options(arguments);
    if (!choice) return program::fail(choice.error(), program::kAskedWrongly);
    const Result<SearchResult> result = run(*choice);
    if (!result) return program::fail(result.error());
    return program::print(arguments.has("json") ? search_json(choice->box, choice->settings, *result)
                                                : search_text(choice->settings, *result));
  });
}

}  // namespace telepalp::study
