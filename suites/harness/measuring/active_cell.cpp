#include "suites/harness/measuring/active_cell.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/number.h"
#include "reports/stats/stats.h"
#include "suites/harness/checks/verify.h"

namespace sb {
namespace {

/// Budgets that the fewest blocks of an interval may take: beyond them a cell is slow, and a budget
/// is what it gets.
constexpr double kPatience = 3;

/// One frame, or one loop of a camera in motion, which then stands at the end of its path again.
/// Its wall time.
double loopMs(Subject& subject, FrameMode mode) {
  double wall = 0;
  for (uint32_t i = 0; i < subject.steps(); ++i) wall += subject.frame(mode).wallMs;
  return wall;
}

}  // namespace

void addOnce(std::vector<std::string>& list, const std::string& text) {
  if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

ActiveCell::ActiveCell(CellResult& result, std::unique_ptr<Subject> subject,
                       const MeasureSettings& settings)
    : m_result(&result),
      m_subject(std::move(subject)),
      m_settings(&settings),
      m_software(m_subject->software()) {
  m_samples.passesUntrusted = m_subject->passesUntrusted();
  m_subject->describe(result.record);
  warmUp();
  m_untimedPicture = contentHashOf(m_subject->picture());
  takeMessages();
  if (!settings.earlierBlocks) return;
  const auto earlier = settings.earlierBlocks->find(result.record.id);
  if (earlier == settings.earlierBlocks->end()) return;
  m_samples.blocks = earlier->second;
  for (const SampleBlock& block : m_samples.blocks)
    for (const FrameResult& f : block.frames) m_seconds += f.wallMs * 1e-3;
}

/// Every pipeline and state is drawn twice before the windows begin.
void ActiveCell::warmUp() {
  m_samples.loop = m_subject->steps();
  const double first = loopMs(*m_subject, FrameMode::Plain);
  double last = first;
  if (m_subject->hasPasses()) {
    last = loopMs(*m_subject, FrameMode::Stamped);
    loopMs(*m_subject, FrameMode::Counted);
  }
  const double frameMs = last / m_subject->steps();
  // Two windows are the fewest that can agree.
  const double budgetMs = m_settings->budgetSeconds * 1e3;
  const bool patient =
      m_settings->stop.repetitions > 0 ||
      2 * wholeLoops(WarmUp::kWindowFrames, m_subject->steps()) * frameMs < budgetMs;
  const uint32_t windowFrames = wholeLoops(
      m_subject->hasPasses() && patient ? WarmUp::kWindowFrames : 1, m_subject->steps());
  WarmUp rule;
  double spentMs = 0;
  for (bool done = false; !done && !interrupted();) {
    std::vector<double> times;
    for (uint32_t i = 0; i < windowFrames; ++i) {
      const FrameResult frame = m_subject->frame(FrameMode::Plain);
      spentMs += frame.wallMs;
      times.push_back(rankingMs(frame, m_software));
    }
    done = rule.add(report::median(times)) || (!patient && spentMs > budgetMs);
  }
  if (!rule.steady())
    m_result->record.warnings.push_back(
        patient ? "ten warm-up windows did not agree: the time drifts"
                : "the warm-up was cut at the budget: a frame takes " +
                      base::numberText(std::round(frameMs)) + " ms");
  const double warm = patient ? loopMs(*m_subject, FrameMode::Plain) : last;
  m_samples.compileMs = m_subject->createMs() + std::max(0.0, first - warm);
  m_frameMs = std::max(warm / double(m_subject->steps()), 1e-3);
  m_framesPerBlock =
      wholeLoops(uint32_t(std::clamp(m_settings->blockSeconds * 1e3 / m_frameMs, 1.0, 32.0)),
                 m_subject->steps());
  m_slow = m_settings->stop.repetitions == 0 &&
           double(m_settings->stop.minBlocks) * blockSeconds() >
               kPatience * m_settings->budgetSeconds;
}

bool ActiveCell::isSpent() const {
  return m_slow && !m_samples.blocks.empty() &&
         m_seconds + blockSeconds() > m_settings->budgetSeconds;
}

std::vector<FrameResult> ActiveCell::frames(FrameMode mode, uint32_t count) {
  std::vector<FrameResult> frames;
  for (uint32_t i = 0; i < count; ++i) frames.push_back(m_subject->frame(mode));
  return frames;
}

void ActiveCell::measureBlock() {
  const size_t pipelines = m_subject->pipelines();
  // A counter that is reset spoils one block, a broken one all.
  for (int attempt = 0;; ++attempt) {
    std::vector<FrameResult> block = frames(FrameMode::Plain, m_framesPerBlock);
    for (const FrameResult& f : block) m_seconds += f.wallMs * 1e-3;
    if (addBlock(m_samples, std::move(block), m_software)) break;
    if (attempt == 2)
      throw std::runtime_error("timer not trusted: the stamps of every frame exceed its wall time");
  }
  if (m_subject->pipelines() != pipelines)
    addOnce(m_result->record.contamination, "a pipeline was created within a timed frame");
  if (m_settings->onBlock) m_settings->onBlock(m_result->record.id, m_samples.blocks.back());
  takeMessages();
}

/// What a device's validation said since the last call belongs to the cell that ran.
void ActiveCell::takeMessages() {
  for (const rhi::Message& m : m_subject->takeMessages())
    addOnce(m_result->record.warnings, "validation: " + m.source + " [" + m.rule + "] " + m.text);
}

void ActiveCell::finish(Stop stop) {
  report::Record& record = m_result->record;
  // The picture first: it must be of the last timed frame.
  m_result->picture = m_subject->picture();
  record.picture = contentHashOf(m_result->picture);
  record.stable = record.picture == m_untimedPicture;
  record.nonfinite = countNonFinite(m_result->picture);
  if (m_subject->hasPasses()) {
    const double fit = m_settings->budgetSeconds * 1e3 / m_frameMs;
    const uint32_t wanted =
        m_slow ? uint32_t(std::clamp(fit, 1.0, double(m_settings->stampedFrames)))
               : m_settings->stampedFrames;
    const uint32_t steps = m_subject->steps();
    for (uint32_t i = 0; i < wanted; i += steps) {
      std::vector<FrameResult> stamped = frames(FrameMode::Stamped, steps);
      addStamped(m_samples, {std::move(stamped), frames(FrameMode::Plain, steps)});
    }
    for (uint32_t i = 0; i < steps; ++i)
      m_samples.counted = m_subject->frame(FrameMode::Counted);
  }
  takeMessages();
  summarise(m_samples, m_software, record);
  if (m_slow && m_samples.blocks.size() < m_settings->stop.minBlocks)
    record.why["precision"] = std::to_string(m_samples.blocks.size()) +
                              " blocks are all that the budget allowed; an interval needs " +
                              std::to_string(m_settings->stop.minBlocks);
  else if (m_samples.blocks.size() < 2)
    record.why["precision"] = "a single block has no interval";
  else
    record.precision = relativeHalfWidth(blockMeans(m_samples, m_software));
  record.stoppedBy = m_slow                    ? "budget"
                     : stop == Stop::Precision ? "precision"
                     : stop == Stop::Budget    ? "budget"
                                               : "repetitions";
}

}  // namespace sb
