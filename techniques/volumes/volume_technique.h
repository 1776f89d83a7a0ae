// What techniques share whose shadow volumes end in a mask: the volumes of a path's steps, the
// mask's slots, what is written at each step.
#pragma once

#include "techniques/volumes/hard_shadows.h"

namespace sb {

class VolumeTechnique : public ShadowTechnique {
 public:
  void prepare(const Context& context) final;
  void moved(Frame& frame) final;
  void record(Frame& frame) final { m_volumes->record(frame); }
  VisibilityInputs inputs() const override;
  std::vector<std::pair<std::string, uint64_t>> counts() const override {
    return m_volumes->counts();
  }

 protected:
  struct Choices {
    VolumeBuilder builder = VolumeBuilder::Cpu;
    VolumeChoice volumes = {};
    CullingChoice culling = {};
  };
  /// Asked first.
  virtual Choices choose(const Context& context) = 0;
  /// Told the volumes of every step.
  virtual void visit(const std::vector<LightVolumes>& lights) = 0;
  virtual MaskKind maskKind() const { return MaskKind::Binary; }
  /// Makes what fills the mask; unless nothing casts.
  virtual void prepareShadows() = 0;
  /// What else of this step is written.
  virtual void writeStep(const ShadowMask::Write&) {}

  /// Of the mask: how many are filled, and that of each light in view.
  virtual uint32_t slotCount(const std::vector<LightVolumes>& lights) const {
    return uint32_t(lights.size());
  }
  virtual std::vector<uint32_t> slots(const std::vector<LightVolumes>& lights) const {
    return maskSlots(context().view, lights);
  }

  const Context& context() const { return *m_context; }
  const ShadowVolumes& volumes() const { return *m_volumes; }
  const ShadowMask& mask() const { return *m_mask; }
  bool hasMask() const { return m_mask.has_value(); }

 private:
  void write(const ShadowMask::Write& write);

  std::optional<Context> m_context;
  std::optional<ShadowVolumes> m_volumes;
  std::optional<ShadowMask> m_mask;  ///< unless nothing casts
};

}  // namespace sb
