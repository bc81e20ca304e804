#include "tools/replay/words/journal_words.h"

#include "proto/words/counted.h"

namespace telepalp::replay {
namespace {

using core::JournalVerdict;

std::string writer_of(const msg::JournalHeader& header) { return build_of(header.version(), header.commit()); }

bool is_of(const msg::JournalHeader& header, const Here& here) {
  return writer_of(header) == here.build && header.machine() == here.processor;
}

std::string values_of(const JournalVerdict& verdict) {
  std::string text = "\nticks whose values differ from the journal's, as doubles\nforce     " +
                     std::to_string(verdict.forces_differ) + "\nphase     " + std::to_string(verdict.phases_differ) +
                     "\nproxy     " + std::to_string(verdict.proxies_differ) + "\n";
  if (verdict.first_difference) text += "the first of them is tick " + std::to_string(*verdict.first_difference) + "\n";
  if (verdict.ticks == 0)
    text += "the journal holds no tick. fix: let the station run until it says that the surface is touchable\n";
  return text;
}

/// Why values may differ although the core is right; empty: no reason is known.
std::string origin_of(const msg::JournalHeader& header, const Here& here) {
  std::string text;
  if (writer_of(header) != here.build)
    text += "note: another build wrote the journal: " + writer_of(header) + "; this is " + here.build +
            ". A difference may come from the code between them. fix: for an exact comparison, run telepalp-replay of "
            "that commit\n";
  if (header.machine() != here.processor)
    text += "note: another machine wrote the journal, with the processor " + header.machine() + "; this one has " +
            here.processor +
            ". Their mathematical functions may round differently. fix: for an exact comparison, run telepalp-replay "
            "on that machine\n";
  return text;
}

std::string limits_of(const ReadJournal& journal, const JournalVerdict& verdict) {
  if (!journal.end)
    return "note: the journal was cut off: it is read up to its last whole block, at byte " +
           std::to_string(journal.whole_bytes) + ", and its first " + counted(verdict.ticks, "tick", "ticks") +
           " are compared. fix: none for these ticks; to keep later ones, end the station by Ctrl-C or --seconds, and "
           "copy the file whole\n";
  if (journal.end->ticks_lost() + journal.end->runs_lost() > 0)
    return "note: the journal is incomplete: the station's disk was too slow for " +
           counted(journal.end->ticks_lost(), "tick", "ticks") + " and " +
           counted(journal.end->runs_lost(), "run", "runs") +
           " of the stages. fix: keep the journal on a disk that takes 5 MB in each second\n";
  return {};
}

}  // namespace

std::string build_of(const std::string& version, const std::string& commit) { return version + ", commit " + commit; }

std::string in_words(const ReadJournal& journal, const JournalVerdict& verdict, const Here& here) {
  const msg::JournalHeader& header = journal.header;
  std::string text = "journal:  " + journal.file + "\nwritten:  " + header.program() + " " + writer_of(header) +
                     ", on " + header.machine() + "\nscene:    " + header.scene_file() + ", surface setting " +
                     header.surface_setting() + "\nreplayed: " + counted(verdict.ticks, "tick", "ticks") + ", " +
                     counted(verdict.surface_runs, "surface run", "surface runs") + ", " +
                     counted(verdict.collision_runs, "collision run", "collision runs") + "\n" + values_of(verdict);
  if (verdict.stopped)
    text += "stopped: " + *verdict.stopped +
            ". The ticks before it are compared, those behind it cannot be. fix: keep the journal again\n";
  text += origin_of(header, here) + limits_of(journal, verdict);
  if (verdict.first_difference && is_of(header, here))
    text +=
        "note: the same build on the same machine computes other values: this is a defect of telepalp. fix: report it, "
        "with the scene and the number of the first tick\n";
  return text;
}

}  // namespace telepalp::replay
