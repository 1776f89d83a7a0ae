// Rules about what a pass declares, checked when it begins.
#include <algorithm>

#include "backends/rhi/validate/rules.h"

namespace rhi::validate {
namespace {

std::string in(const PassCheck& c) { return "pass '" + c.pass.label + "': "; }

template <class F>
void eachUse(const PassCheck& c, F&& visit) {
  for (const ResourceUse& use : c.pass.reads) visit(use, false);
  for (const ResourceUse& use : c.pass.writes) visit(use, true);
}

/// Attachment views with the field's name; `written` is false for read-only depth.
template <class F>
void eachAttachment(const PassCheck& c, F&& visit) {
  for (size_t i = 0; i < c.pass.colors.size(); ++i) {
    const std::string field = "colors[" + std::to_string(i) + "]";
    visit(c.pass.colors[i].view, field, true);
    if (c.pass.colors[i].resolve) visit(*c.pass.colors[i].resolve, field + ".resolve", true);
  }
  if (c.pass.depth) visit(c.pass.depth->view, "depth", !c.pass.depth->readOnly);
}

std::string describeUse(const PassCheck& c, const ResourceUse& use) {
  return use.buffer ? describe(c.state, use.buffer) : describe(c.state, use.view.texture);
}

void useTarget(const PassCheck& c, const Emit& emit) {
  eachUse(c, [&](const ResourceUse& use, bool write) {
    if (bool(use.buffer) == bool(use.view.texture))
      emit(in(c) + "a use in " + (write ? "writes" : "reads") +
           " names not exactly one buffer or texture");
  });
}

void useAccess(const PassCheck& c, const Emit& emit) {
  eachUse(c, [&](const ResourceUse& use, bool write) {
    if (write != (use.access == Access::StorageWrite))
      emit(in(c) + describeUse(c, use) +
           (write ? " stands in writes without Access::StorageWrite"
                  : " stands in reads with Access::StorageWrite"));
  });
}

void useFlag(const PassCheck& c, const Emit& emit) {
  eachUse(c, [&](const ResourceUse& use, bool) {
    if (const BufferInfo* buffer = c.state.find(use.buffer)) {
      static constexpr BufferUse kNeeds[] = {
          BufferUse::Uniform, BufferUse::Vertex,  BufferUse::Index,  BufferUse::Indirect,
          BufferUse::None,    BufferUse::Storage, BufferUse::Storage};
      if (!has(buffer->desc.use, kNeeds[size_t(use.access)]))
        emit(in(c) + describeUse(c, use) + " is declared for an access its `use` does not allow");
    } else if (const TextureInfo* texture = c.state.find(use.view.texture)) {
      const TextureUse needs = use.access == Access::Sampled        ? TextureUse::Sampled
                               : use.access == Access::StorageRead  ? TextureUse::Storage
                               : use.access == Access::StorageWrite ? TextureUse::Storage
                                                                    : TextureUse::None;
      if (!has(texture->desc.use, needs))
        emit(in(c) + describeUse(c, use) + " is declared for an access its `use` does not allow");
    }
  });
}

void attachmentFlag(const PassCheck& c, const Emit& emit) {
  eachAttachment(c, [&](const TextureView& view, const std::string& field, bool) {
    const TextureInfo* texture = c.state.find(view.texture);
    const TextureUse needs = field == "depth" ? TextureUse::DepthTarget : TextureUse::ColorTarget;
    if (texture && !has(texture->desc.use, needs))
      emit(in(c) + field + " is " + describe(c.state, view.texture) +
           ", whose `use` does not allow that");
  });
}

void viewRange(const PassCheck& c, const Emit& emit) {
  auto check = [&](const TextureView& view, const std::string& field) {
    const TextureInfo* texture = c.state.find(view.texture);
    if (texture && !texture->contains(texture->range(view)))
      emit(in(c) + field + " reaches outside " + describe(c.state, view.texture));
  };
  eachAttachment(c, [&](const TextureView& view, const std::string& f, bool) { check(view, f); });
  eachUse(c, [&](const ResourceUse& use, bool write) {
    if (use.view.texture) check(use.view, write ? "a view in writes" : "a view in reads");
  });
}

void destroyedResource(const PassCheck& c, const Emit& emit) {
  eachAttachment(c, [&](const TextureView& view, const std::string& field, bool) {
    if (!c.state.find(view.texture)) emit(in(c) + field + " is " + describe(c.state, view.texture));
  });
  eachUse(c, [&](const ResourceUse& use, bool write) {
    const bool missing = use.buffer ? !c.state.find(use.buffer)
                                    : use.view.texture && !c.state.find(use.view.texture);
    if (missing) emit(in(c) + (write ? "writes" : "reads") + " names " + describeUse(c, use));
  });
}

void attachmentShape(const PassCheck& c, const Emit& emit) {
  std::optional<Extent2D> extent;
  std::optional<uint32_t> samples;
  eachAttachment(c, [&](const TextureView& view, const std::string& field, bool) {
    const TextureInfo* texture = c.state.find(view.texture);
    if (!texture || !texture->contains(texture->range(view))) return;
    const Range range = texture->range(view);
    if (range.mipEnd - range.baseMip != 1) emit(in(c) + field + " views more than one mip");
    const Extent2D own = {std::max(1u, texture->desc.width >> range.baseMip),
                          std::max(1u, texture->desc.height >> range.baseMip)};
    if (extent && !(own == *extent)) emit(in(c) + field + " has another extent than the first");
    if (!extent) extent = own;
    if (field.ends_with(".resolve")) {
      if (texture->desc.samples != 1) emit(in(c) + field + " is itself multisampled");
      return;
    }
    if (samples && texture->desc.samples != *samples)
      emit(in(c) + field + " has another sample count than the first");
    samples = texture->desc.samples;
  });
}

void passExtent(const PassCheck& c, const Emit& emit) {
  const bool attachments = !c.pass.colors.empty() || c.pass.depth;
  if (c.pass.compute && attachments) emit(in(c) + "a compute pass has attachments");
  if (!c.pass.compute && !attachments && (c.pass.extent.width == 0 || c.pass.extent.height == 0))
    emit(in(c) + "`extent` is needed without attachments");
}

bool anyWritten(const PassCheck& c, const TextureView& view) {
  const TextureInfo* texture = c.state.find(view.texture);
  if (!texture || !texture->contains(texture->range(view))) return true;  // another rule's business
  bool any = false;
  texture->each(texture->range(view), [&](const Content& content) { any |= content.written; });
  return any;
}

void readNeverWritten(const PassCheck& c, const Emit& emit) {
  for (const ResourceUse& use : c.pass.reads) {
    const BufferInfo* buffer = c.state.find(use.buffer);
    const bool written = use.buffer ? !buffer || buffer->content.written
                                    : !use.view.texture || anyWritten(c, use.view);
    if (!written) emit(in(c) + "reads " + describeUse(c, use) + ", which nothing has written");
  }
}

void loadNeverWritten(const PassCheck& c, const Emit& emit) {
  auto check = [&](const TextureView& view, LoadOp load, const std::string& field) {
    if (load == LoadOp::Load && !anyWritten(c, view))
      emit(in(c) + field + " loads " + describe(c.state, view.texture) +
           ", which nothing has written");
  };
  for (size_t i = 0; i < c.pass.colors.size(); ++i)
    check(c.pass.colors[i].view, c.pass.colors[i].load, "colors[" + std::to_string(i) + "]");
  if (!c.pass.depth) return;
  check(c.pass.depth->view, c.pass.depth->load, "depth");
  const TextureInfo* texture = c.state.find(c.pass.depth->view.texture);
  if (!texture || !formatInfo(texture->desc.format).stencil ||
      c.pass.depth->stencilLoad != LoadOp::Load ||
      !texture->contains(texture->range(c.pass.depth->view)))
    return;
  bool written = false;
  texture->each(texture->range(c.pass.depth->view),
                [&](const Content& content) { written |= content.stencil; });
  if (!written)
    emit(in(c) + "depth loads the stencil of " + describe(c.state, c.pass.depth->view.texture) +
         ", which nothing has written");
}

void readOnlyDepth(const PassCheck& c, const Emit& emit) {
  if (c.pass.depth && c.pass.depth->readOnly && c.pass.depth->load != LoadOp::Load)
    emit(in(c) + "depth is read-only, so `load` must be LoadOp::Load");
  if (c.pass.depth && c.pass.depth->stencilReadOnly && c.pass.depth->stencilLoad != LoadOp::Load)
    emit(in(c) + "stencil is read-only, so `stencilLoad` must be LoadOp::Load");
}

void attachmentFeedback(const PassCheck& c, const Emit& emit) {
  eachAttachment(c, [&](const TextureView& view, const std::string& field, bool written) {
    eachUse(c, [&](const ResourceUse& use, bool) {
      if (!use.view.texture || !overlap(c.state, view, use.view)) return;
      if (written || use.access != Access::Sampled)
        emit(in(c) + describeUse(c, use) + " is attached as " + field +
             " and declared for another access");
    });
  });
}

constexpr Rule<PassCheck> kRules[] = {
    {"use-target", useTarget},
    {"use-access", useAccess},
    {"use-flag", useFlag},
    {"attachment-flag", attachmentFlag},
    {"view-range", viewRange},
    {"destroyed-resource", destroyedResource},
    {"attachment-shape", attachmentShape},
    {"pass-extent", passExtent},
    {"read-never-written", readNeverWritten},
    {"load-never-written", loadNeverWritten},
    {"read-only-depth", readOnlyDepth},
    {"attachment-feedback", attachmentFeedback},
};

}  // namespace

std::span<const Rule<PassCheck>> passRules() { return kRules; }

}  // namespace rhi::validate
