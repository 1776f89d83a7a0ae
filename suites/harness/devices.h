// The devices of a run: one per backend, opened at first use and shared by all cells. A backend
// whose driver does not start is remembered with its reason; the run goes on with the others.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "backends/rhi/device.h"
#include "backends/rhi/validate/validator.h"
#include "suites/harness/checks/timer_trust.h"
#include "techniques/render/renderer.h"

namespace sb {

/// A device with what its cells share. Destroyed in reverse order of its members.
struct DeviceSession {
  std::unique_ptr<rhi::Device> device;
  std::unique_ptr<rhi::Validator> validator;  ///< only with validation
  std::unique_ptr<PipelineCache> pipelines;
  std::unique_ptr<FrameQueries> queries;
  const rhi::ShaderLibrary* shaders = nullptr;
  std::vector<TimerFact> timers;  ///< see Devices::timersOf
  DeviceContext context() { return {*device, *shaders, *pipelines, *queries}; }
};

class Devices {
 public:
  /// `backends` and `shaders` must outlive this object.
  Devices(std::vector<rhi::Backend*> backends, const rhi::ShaderLibrary& shaders,
          rhi::DeviceRequest request);

  std::vector<std::string> names() const;
  /// Opens the backend's device if need be; null when it does not start (see `why`).
  DeviceSession* open(const std::string& backend);
  /// Why `open` gave null.
  std::string why(const std::string& backend) const;
  /// The backend's device was lost: nothing more is asked of it.
  void lose(const std::string& backend, const std::string& reason);
  /// "the device was lost: ...", or "".
  std::string whyLost(const std::string& backend) const;
  /// What the timers of an open device are worth: checked once, at first use.
  static const std::vector<TimerFact>& timersOf(DeviceSession& session);
  /// A device was asked for, and no backend that was opened has it: the errors of all of them.
  std::string whyNoSuchDevice() const;
  bool validating() const { return m_request.validate; }
  std::vector<rhi::Backend*> backends() const { return m_backends; }

 private:
  std::vector<rhi::Backend*> m_backends;
  const rhi::ShaderLibrary& m_shaders;
  rhi::DeviceRequest m_request;
  std::map<std::string, DeviceSession> m_sessions;
  std::map<std::string, std::string> m_lost;  ///< why, by backend
  std::map<std::string, std::string> m_failures;
  std::string m_unmatched;  ///< failures to find the device asked for
};

}  // namespace sb
