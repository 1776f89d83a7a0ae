// What a run has found so far, on disk at once: a line of JSON for what the run is, and one for
// each block, finished cell and hard case. A run that ends early, by Ctrl-C or `kill -9`, goes on
// from it
// (`--resume`): nothing is measured twice. Pictures lie beside it and are written before the line
// that names them.
//   {"journal":2, "arguments":[..], "folder":.., "program":.., "settings":{..}, "scenes":{..},
//    "devices":{..}, "cells":[..], "hard_cases":[..]}
//   {"block":{"cell":{"technique":.., ..}, "frames":[[wall, cpu, record, submit, device or null,
//    passes, draws, dispatches, triangles], ..]}}
//   {"cell":[entries as in the results]}      the last line of a cell counts
//   {"hard_case":{..}}
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/record.h"
#include "suites/harness/measuring/samples.h"

namespace sb {

/// What must be the same for a run to go on.
struct JournalHeader {
  std::vector<std::string> arguments;  ///< of the program
  std::string folder;                  ///< that relative paths of them count from
  std::string program;                 ///< version, commit, build
  std::map<std::string, std::string> settings;
  std::map<std::string, std::string> scenes;   ///< hash by spec
  std::map<std::string, std::string> devices;  ///< by backend
  std::vector<std::string> cells, hardCases;   ///< names, all that are to be measured
};

/// What differs between the run of a journal and this one, in words; empty when nothing does.
std::vector<std::string> differences(const JournalHeader& there, const JournalHeader& here);

struct JournalContent {
  JournalHeader header;
  std::map<report::CellId, report::Record> cells;
  std::map<std::string, report::StabilityRecord> hardCases;
  std::map<report::CellId, std::vector<SampleBlock>> blocks;
  uint64_t wholeBytes = 0;   ///< up to the end of the last whole line
  bool halfLine = false;     ///< something was cut off behind it
};

/// Throws InputError naming file and line. A last line that was cut off is left out.
JournalContent readJournal(const std::filesystem::path& path);

/// Whether a run, of this process or of another, is writing it.
bool isJournalInUse(const std::filesystem::path& path);

class Journal {
 public:
  /// Begins a journal. Throws InputError when it cannot be written, or another run writes it.
  Journal(const std::filesystem::path& path, const JournalHeader& header);
  /// Goes on with one.
  Journal(const std::filesystem::path& path, const JournalContent& content);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void block(const report::CellId& cell, const SampleBlock& block);
  void cell(const report::Record& record);
  void hardCase(const report::StabilityRecord& record);

  const std::filesystem::path& path() const { return m_path; }
  /// Why a line could not be written, or "": the run goes on without it.
  const std::string& failure() const { return m_failure; }
  /// Everything has been written elsewhere.
  void remove();

 private:
  /// `durable`: waits until the line is on the disk.
  void append(const std::string& line, bool durable);
  /// Until the file is closed, however the process ends.
  void lock();

  std::filesystem::path m_path;
  int m_file = -1;
  std::string m_failure;
};

}  // namespace sb
