#include "tools/study/protocol/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "tests/support/child_process.h"
#include "tests/tools/study/texts.h"
#include "tools/study/protocol/desk.h"
#include "tools/study/protocol/hands/browser_trial.h"
#include "tools/study/protocol/page_answers.h"
#include "tools/study/protocol/people.h"
#include "tools/study/run/trial_row.h"
#include "where.h"

namespace telepalp::study {
namespace {

namespace fs = std::filesystem;

Protocol small() {
  return {.design = *parse_design("name=long l_h=180\nname=short l_h=60\n", "two"),
          .conditions = {Condition::Both, Condition::Vision},
          .seed = 3,
          .training = 1,
          .penetrations = 2};
}
const Participant kAnna = *participant_of("anna");
JournalHead head_of(const Protocol& protocol) { return {.identity = identity_of(protocol), .participant = kAnna.name}; }
fs::path journal_of(const support::TemporaryFolder& folder) { return journal_file(folder.path(), kAnna.name); }

Desk desk_of(
    const Protocol& protocol, const fs::path& file, std::function<void()> over = [] {}) {
  Result<Journal> journal = Journal::open(file, head_of(protocol));
  EXPECT_TRUE(journal.ok()) << to_string(journal.error());
  Result<Session> session = Session::make(protocol, kAnna, journal->attempts(), file.string());
  EXPECT_TRUE(session.ok()) << to_string(session.error());
  return {std::move(*session), std::move(*journal), kAnna.name, std::move(over)};
}

/// Tissue of the middle plant, which takes long to make.
const std::shared_ptr<const tissue::TissueModel>& middle_tissue() {
  static const std::shared_ptr<const tissue::TissueModel> tissue = *tissue::make_tissue(tissue_of(Plant{}));
  return tissue;
}

Prepared prepared(std::size_t mechanism) {
  Prepared made{.tool = *linkage_tool(small().design.configurations[mechanism], Plant{}), .insertion = nullptr};
  made.insertion = std::make_unique<Insertion>(*made.tool, middle_tissue());
  return made;
}

/// A person who pushes at 40 mm/s for 3.5 s, which goes through the sac, and then stands still.
void penetrate(Desk& desk) {
  constexpr double kStep_s = 0.016;
  ASSERT_TRUE(desk.obey(BeginPenetration{}));
  for (int frame = 0; frame < 3000 && desk.session().stage() != Stage::Resting; ++frame) {
    if (desk.session().stage() == Stage::Finished) return;
    if (frame < 220) (void)desk.obey(PushHand{0.04 * kStep_s});
    (void)desk.step(kStep_s);
  }
  ASSERT_EQ(desk.session().stage(), Stage::Resting);
}

TEST(ProtocolPlan, HasTrainingAndThenEachMechanismInEachCondition) {
  const Protocol protocol{.design = amniocentesis_design(), .conditions = {Condition::Force, Condition::Both}};
  const std::vector<Planned> plan = plan_of(protocol, kAnna);
  ASSERT_EQ(plan.size(), 2 * (15 + 36 * 5));
  for (const std::size_t block : {0UL, 195UL}) {
    std::map<std::size_t, int> trained;
    std::map<std::size_t, int> tried;
    for (std::size_t i = block; i < block + 195; ++i) {
      EXPECT_EQ(plan[i].training, i < block + 15);
      EXPECT_EQ(plan[i].condition, plan[block].condition);
      ++(plan[i].training ? trained : tried)[plan[i].configuration];
    }
    EXPECT_EQ(trained.size(), 3U) << "three mechanisms, as S4 has it";
    EXPECT_EQ(tried.size(), 36U);
    for (const auto& [mechanism, times] : tried) EXPECT_EQ(times, 5) << mechanism;
  }
  EXPECT_NE(plan[0].condition, plan[195].condition);
}

TEST(ProtocolPlan, DependsOnSeedAndParticipantAlone) {
  const auto order = [](std::uint64_t seed, const char* name) {
    std::string text;
    for (const Planned& one : plan_of({.design = amniocentesis_design(), .conditions = {Condition::Both}, .seed = seed},
                                      *participant_of(name)))
      text += std::to_string(one.configuration) + " ";
    return text;
  };
  EXPECT_EQ(order(1, "anna"), order(1, "anna"));
  EXPECT_NE(order(1, "anna"), order(2, "anna"));
  EXPECT_NE(order(1, "anna"), order(1, "bert"));
}

TEST(ProtocolPlan, HasTheOrderOfASimulatedOperatorOfThisNumber) {
  const Protocol protocol{.design = amniocentesis_design(), .conditions = {Condition::Both}, .training = 0};
  const BlockOrder order = block_order(protocol.seed, kAnna.number, Condition::Both, 36);
  const std::vector<Planned> plan = plan_of(protocol, kAnna);
  for (std::size_t place = 0; place < 36; ++place) EXPECT_EQ(plan[5 * place].configuration, order.formal[place]);
}

TEST(ProtocolWords, RefuseNamesAndConditionsWithAWayToFixThem) {
  for (const char* name : {"", "../up", "a b", "anna/x", "ä", "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"})
    EXPECT_FALSE(participant_of(name).ok()) << name;
  for (const char* text : {"", "both,", "both,both", "no-reflexes", "sight", ","})
    EXPECT_FALSE(read_conditions(text).ok()) << text;
  EXPECT_EQ(read_conditions("vision,force")->size(), 2U);
}

/// The hand of a simulated operator, and where it was at each tick.
class RecordedHand final : public HandMotion {
 public:
  explicit RecordedHand(SimulatedHand& hand) : hand_(hand) {}
  Eigen::Vector3d next_m(const Insertion& insertion) noexcept override {
    places_m.push_back(hand_.next_m(insertion));
    return places_m.back();
  }
  std::vector<Eigen::Vector3d> places_m;

 private:
  SimulatedHand& hand_;
};

TEST(Insertion, APersonsHandOnTheWayOfASimulatedOneOvershootsAsFar) {
  const Plant plant;
  const std::shared_ptr<const tissue::TissueModel>& tissue = middle_tissue();
  const Design design = *parse_design("l_h=140", "one");
  const Operator person;
  for (const Condition condition : {Condition::Force, Condition::Vision, Condition::Both}) {
    const auto simulated_tool = linkage_tool(design.configurations[0], plant);
    Learned learned{.depth_m = 0.04, .from = 5};
    device::Random random(7);
    const Penetration one{**simulated_tool, tissue, person, condition};
    SimulatedHand hand(one, learned, random);
    RecordedHand recorded(hand);
    Insertion simulated(**simulated_tool, tissue);
    while (!simulated.over()) simulated.step(recorded.next_m(simulated));

    const auto persons_tool = linkage_tool(design.configurations[0], plant);
    Insertion persons(**persons_tool, tissue);
    for (const Eigen::Vector3d& place_m : recorded.places_m) persons.step(place_m);
    ASSERT_TRUE(persons.over());
    EXPECT_GT(persons.outcome().overshoot_m, 0.001);
    EXPECT_EQ(persons.outcome().overshoot_m, simulated.outcome().overshoot_m) << name(condition);
    EXPECT_EQ(persons.outcome().seconds, simulated.outcome().seconds);

    const auto again_tool = linkage_tool(design.configurations[0], plant);
    device::Random again(7);
    const Outcome whole = penetrate({**again_tool, tissue, person, condition}, learned, again);
    EXPECT_EQ(whole.overshoot_m, simulated.outcome().overshoot_m) << "the study runs the same insertion";
  }
}

TEST(BrowserHand, IsThrownForwardByTheForceOnlyWhereForceIsShown) {
  const auto deepest_m = [](Condition condition) {
    BrowserTrial trial(prepared(1), condition);
    PersonTrial::Ticks ticks;
    for (int i = 0; i < 2000 && !trial.insertion().over(); ++i) {
      if (!trial.insertion().through()) trial.push(0.0005);
      trial.step(0.016, ticks);
    }
    EXPECT_TRUE(trial.insertion().through()) << name(condition);
    const Outcome out = trial.insertion().outcome();
    return out.deepest_m;
  };
  EXPECT_GT(deepest_m(Condition::Both), deepest_m(Condition::Vision) + 0.0005);
}

TEST(BrowserHand, ALateProgramMakesTheHandSlowAndSaysSo) {
  BrowserTrial trial(prepared(0), Condition::Both);
  PersonTrial::Ticks ticks;
  trial.push(0.3);
  trial.step(1.0, ticks);
  EXPECT_NEAR(trial.insertion().time_s(), BrowserTrial::kLongestStep_s, 1e-3);
  EXPECT_NEAR(trial.view().held_up_s, 0.95, 1e-9);
  trial.push(std::numeric_limits<double>::quiet_NaN());
  trial.step(0.05, ticks);
  EXPECT_TRUE(trial.insertion().tool().tip_m().allFinite());
}

TEST(ProtocolDesk, TellsEachOvershootAndGoesOnWhereItWasEnded) {
  const support::TemporaryFolder folder;
  const Protocol protocol = small();
  int over = 0;
  {
    Desk desk = desk_of(protocol, journal_of(folder));
    EXPECT_EQ(desk.session().all(), 10U);
    for (int i = 0; i < 3; ++i) penetrate(desk);
    EXPECT_EQ(desk.session().done(), 3U);
    EXPECT_TRUE(says(desk.state(), "\"overshoot\": ")) << desk.state();
  }
  Desk desk = desk_of(protocol, journal_of(folder), [&] { ++over; });
  EXPECT_EQ(desk.session().done(), 3U);
  while (desk.session().stage() != Stage::Finished) penetrate(desk);
  EXPECT_EQ(over, 1);
  EXPECT_FALSE(desk.obey(BeginPenetration{})) << "nothing comes after the last one";

  const PeopleResult result = result_of(protocol, *read_people(protocol, folder.path()));
  ASSERT_EQ(result.people.records.size(), 1U);
  EXPECT_TRUE(result.finished());
  for (const PeopleCondition& one : result.conditions) {
    EXPECT_EQ(one.penetrations, 4);
    EXPECT_GT(one.all.mean, 1.0);
  }
  EXPECT_TRUE(says(people_text(protocol, result), "force shown as a bar"));
  const std::string page = people_html(protocol, result);
  EXPECT_TRUE(says(page, "<svg")) << "the plots";
  EXPECT_FALSE(says(page, "nan"));
  std::istringstream rows(people_csv(protocol, result));
  int trials = 0;
  for (std::string row; std::getline(rows, row);) trials += read_trial(row).has_value() ? 1 : 0;
  EXPECT_EQ(trials, 8) << "in the form of a simulated study, training left out";
}

TEST(ProtocolDesk, EscapeBeforeThePunctureIsRepeatedAndAfterItCounts) {
  const support::TemporaryFolder folder;
  const Protocol protocol = small();
  Desk desk = desk_of(protocol, journal_of(folder));
  EXPECT_FALSE(desk.obey(LetGo{})) << "nothing is under way";
  (void)desk.obey(BeginPenetration{});
  EXPECT_TRUE(desk.obey(LetGo{}));
  EXPECT_TRUE(desk.journal().attempts().empty()) << "the hand had not moved";
  (void)desk.obey(BeginPenetration{});
  (void)desk.obey(PushHand{0.001});
  (void)desk.step(0.016);
  EXPECT_TRUE(desk.obey(LetGo{}));
  ASSERT_EQ(desk.journal().attempts().size(), 1U);
  EXPECT_EQ(desk.journal().attempts()[0].kind, AttemptKind::BrokenOff);
  EXPECT_EQ(desk.session().done(), 0U);

  (void)desk.obey(BeginPenetration{});
  for (int i = 0; i < 2000 && desk.journal().attempts().size() == 1; ++i) {
    if (i < 300) (void)desk.obey(PushHand{0.0006});
    if (i == 299) desk.leave();  // the browser is closed while the needle is far inside
    (void)desk.step(0.016);
  }
  ASSERT_EQ(desk.journal().attempts().size(), 2U);
  EXPECT_EQ(desk.journal().attempts()[1].kind, AttemptKind::Training);
  EXPECT_TRUE(desk.journal().attempts()[1].trial.outcome.through);
  EXPECT_EQ(desk.session().done(), 1U);
}

TEST(ProtocolAnswers, HideWhatTheConditionHides) {
  const auto frame = [](Condition condition) {
    return trial_frame_json(BrowserTrial(prepared(0), condition).view(), condition);
  };
  EXPECT_FALSE(says(frame(Condition::Force), "seen"));
  EXPECT_TRUE(says(frame(Condition::Force), "hand_N"));
  EXPECT_TRUE(says(frame(Condition::Vision), "seen"));
  EXPECT_FALSE(says(frame(Condition::Vision), "hand_N"));
  EXPECT_FALSE(says(frame(Condition::Both), "tip")) << "only the needle outside the skin is told";
}

Attempt attempt_of(const Planned& planned) {
  return {.kind = planned.training ? AttemptKind::Training : AttemptKind::Formal,
          .trial = {.condition = planned.condition,
                    .place = planned.place,
                    .configuration = planned.configuration,
                    .penetration = planned.penetration,
                    .outcome = {.through = true, .stopped = true, .overshoot_m = 0.0071}},
          .held_up_s = 0.0};
}

TEST(ProtocolJournal, ACutOffRowIsAskedForAgain) {
  const support::TemporaryFolder folder;
  const Protocol protocol = small();
  const std::vector<Planned> plan = plan_of(protocol, kAnna);
  {
    Result<Journal> journal = Journal::open(journal_of(folder), head_of(protocol));
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(journal->add(attempt_of(plan[static_cast<std::size_t>(i)])).ok());
  }
  const std::string whole = text_of(journal_of(folder));
  std::ofstream(journal_of(folder), std::ios::binary | std::ios::trunc) << whole.substr(0, whole.size() - 9);
  const Result<Journal> again = Journal::open(journal_of(folder), head_of(protocol));
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_TRUE(again->repaired());
  EXPECT_EQ(again->attempts().size(), 2U);
  EXPECT_EQ(again->attempts()[1].trial.outcome.overshoot_m, 0.0071);
  EXPECT_EQ(text_of(journal_of(folder)), whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
}

TEST(ProtocolJournal, DamageIsSaidWithLineAndColumn) {
  const Protocol protocol = small();
  const std::vector<Planned> plan = plan_of(protocol, kAnna);
  const std::string good =
      journal_begin(head_of(protocol)) + journal_line(attempt_of(plan[0])) + journal_line(attempt_of(plan[1]));
  ASSERT_TRUE(parse_journal(good, "j").ok());
  const auto error_of = [&](std::string text) { return to_string(parse_journal(text, "j.csv").error()); };
  std::string bent = good;
  bent[bent.find("0.0071") + 2] = '9';
  EXPECT_TRUE(says(error_of(bent), "j.csv:4:1: the row is damaged")) << error_of(bent);
  EXPECT_TRUE(says(error_of("nothing\n"), "j.csv:1:1"));
  EXPECT_TRUE(says(error_of(""), "j.csv:1:1"));
  EXPECT_TRUE(says(error_of(good + "\n"), "j.csv:6:1"));

  const std::vector<Attempt> swapped{attempt_of(plan[1]), attempt_of(plan[0])};
  const auto done = done_of(plan, swapped, "j.csv");
  ASSERT_FALSE(done.ok());
  EXPECT_TRUE(says(to_string(done.error()), "j.csv:4:1: the row is not the penetration that comes next"));
}

TEST(ProtocolJournal, OfAnotherProtocolIsRefusedAndLeftAsItIs) {
  const support::TemporaryFolder folder;
  Protocol protocol = small();
  ASSERT_TRUE(Journal::open(journal_of(folder), head_of(protocol)).ok());
  const std::string before = text_of(journal_of(folder));
  protocol.seed = 4;
  const Result<Journal> other = Journal::open(journal_of(folder), head_of(protocol));
  ASSERT_FALSE(other.ok());
  EXPECT_TRUE(says(to_string(other.error()), "another protocol")) << to_string(other.error());
  EXPECT_EQ(text_of(journal_of(folder)), before);
  EXPECT_EQ(read_people(protocol, folder.path())->left_out, std::vector<std::string>{"anna"});
}

TEST(ProtocolPage, RefusesAnythingButItsFourMessages) {
  for (const char* text : {"", "begin ", "push", "push nan", "push inf", "push 1001", "push 1 2", "move 1", "move 1 x",
                           "move  1 2", "stop it", "insert"})
    EXPECT_FALSE(parse_page_command(text).ok()) << text;
  EXPECT_EQ(std::get<PushHand>(*parse_page_command("push -0.5")).by_m, -0.0005);
  EXPECT_TRUE(std::get<MoveHand>(*parse_page_command("move 1.5 -2")).by_m.isApprox(Eigen::Vector2d(0.0015, -0.002)));
}

TEST(ProtocolProgram, RefusesABadListWithItsPlaceAndAPersonWithoutAName) {
  const support::TemporaryFolder folder;
  const fs::path list = folder.path() / "list.txt";
  const fs::path log = folder.path() / "log";
  std::ofstream(list) << "l1=80\nlength=3\n";
  const fs::path program = fs::path(TELEPALP_BINARY_DIR) / "bin" / "telepalp-study";
  const std::string out = (folder.path() / "out").string();
  support::ChildProcess bad(program, {"protocol", "--design", list.string(), "--participant", "p1", "--out", out}, log);
  EXPECT_EQ(bad.wait(std::chrono::seconds(20)), 2);
  EXPECT_TRUE(says(text_of(log), "list.txt:2:1: 'length' is no parameter of a mechanism")) << text_of(log);
  support::ChildProcess nobody(program, {"protocol", "--out", out}, log);
  EXPECT_EQ(nobody.wait(std::chrono::seconds(20)), 2);
  EXPECT_TRUE(says(text_of(log), "--participant: '' is not a short name")) << text_of(log);
  support::ChildProcess empty(program, {"protocol", "--report", "--out", out}, log);
  EXPECT_EQ(empty.wait(std::chrono::seconds(20)), 1);
  EXPECT_TRUE(says(text_of(log), "nobody has followed this protocol")) << text_of(log);
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace telepalp::study
