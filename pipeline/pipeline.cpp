// SPDX-License-Identifier: MIT
#include "pipeline/pipeline.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/base/memory_room.h"
#include "pipeline/gl/context.h"
#include "pipeline/gl/gl_context.h"
#include "pipeline/pass_list.h"
#include "pipeline/passes/gbuffer/meshes.h"
#include "pipeline/passes/gbuffer/visible_range.h"
#include "pipeline/passes/lines/reference.h"
#include "pipeline/passes/strokes/curve_lines.h"
#include "pipeline/passes/strokes/strokes.h"
#include "pipeline/supersample.h"

namespace inkbench {
namespace {

/// What drawing takes, measured on the software renderer with frames of 1024 to 4096 px a side: 88 for
/// `final`, 44 for `reference`, 116 for all buffers.
constexpr double kBytesPerPixel = 88;

/// From the offset that is shown as black to the one that is white.
constexpr float kShownOffsetsPx = 64;

/// Is the renderer a program of the processor, with textures in its memory?
bool draws_in_memory(const RendererInfo& info) {
  return info.renderer.find("llvmpipe") != std::string::npos ||
         info.renderer.find("softpipe") != std::string::npos;
}

/// The gain and offset that show the range, if one is wanted.
PictureView view_of(const DisplayParams& display, BufferName buffer, const std::optional<ShownRange>& range) {
  const BufferInfo& info = buffer.info();
  PictureView view{gain_of(display, buffer), info.first_channel};
  if (info.shown_as == ShownAs::colour) view.channel = PictureView::kColour;
  if (info.shown_as == ShownAs::object_id)
    view.channel = info.first_channel == 3 ? PictureView::kAlphaId : PictureView::kObjectId;
  if (info.shown_as == ShownAs::edge_class) view.channel = PictureView::kEdgeClass;
  if (info.shown_as == ShownAs::offset) view = {1.0F / kShownOffsetsPx, PictureView::kOffset};
  if (!range || !has_range(buffer)) return view;
  const float width = range->white - range->black;
  view.low = range->black;
  view.gain = width > 0.0F ? 1.0F / width : 1.0F;
  return view;
}

/// `times` a side: drawn larger and filtered down, which the settings' other parts decide as they do the
/// buffer; 1: not.
Key picture_key(const PictureView& view, const Key& buffer, const Key& program, int times) {
  KeyBuilder key;
  key.add("picture").add(program).add(buffer).add(fmt::format("{} {} {}", view.channel, view.gain, view.low));
  if (times > 1) key.add(fmt::format("supersampled {}", times));
  return key.key();
}

Image part_of(const Image& image, int left, int top, int width_px, int height_px) {
  Image part(width_px, height_px, image.channels);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      for (int c = 0; c < image.channels; ++c) part.at(x, y, c) = image.at(left + x, top + y, c);
    }
  }
  return part;
}

}  // namespace

ShownRange gain_range(const DisplayParams& display, BufferName buffer) {
  return {0.0F, 1.0F / gain_of(display, buffer)};
}

Pipeline::Pipeline() : Pipeline(std::make_shared<LineFinder>()) {}

Pipeline::Pipeline(std::shared_ptr<LineFinder> finder)
    : Pipeline(std::move(finder), std::make_shared<MeshStore>()) {}

Pipeline::Pipeline(std::shared_ptr<LineFinder> finder, std::shared_ptr<MeshStore> meshes)
    : pool_user_(GlContext::current().textures()), flow_(generated_sources()) {
  flow_.share(std::move(finder));
  flow_.share(std::move(meshes));
  for (const PassKind* pass : all_passes()) flow_.add(*pass);
  picture_pass();
  box_filter();
  throw_gl_errors("making the programs");
}

Pipeline::~Pipeline() = default;

BoxFilterPass& Pipeline::box_filter() {
  return flow_.shared<BoxFilterPass>();
}

Supersampler& Pipeline::supersampler() {
  if (!supersampler_)
    supersampler_ = std::make_unique<Supersampler>(line_finder(), flow_.sharing<MeshStore>());
  return *supersampler_;
}

Frame Frame::without_past() const {
  auto state = std::make_shared<FrameState>(state_->settings, nullptr, state_->window);
  state->keys = state_->keys;
  state->given = state_->given;
  return {*pipeline_, std::move(state)};
}

Frame Pipeline::make_frame(std::shared_ptr<FrameState> state) {
  for (const auto& node : flow_.nodes()) state->keys.push_back(node->key(*state));
  return {*this, std::move(state)};
}

Frame Pipeline::at(const Settings& settings) {
  return make_frame(std::make_shared<FrameState>(settings, nullptr));
}

Frame Pipeline::at(const Settings& settings, const Frame& previous) {
  return make_frame(std::make_shared<FrameState>(settings, flow_.looks_back() ? previous.state_ : nullptr));
}

Frame Pipeline::at(const Settings& settings, const ImageWindow& part, std::vector<GivenValue> given) {
  auto state = std::make_shared<FrameState>(settings, nullptr, part);
  state->given = std::move(given);
  return make_frame(std::move(state));
}

void Pipeline::check_room(const ImageParams& image, const std::string& where, const std::string& instead) {
  const double pixels = static_cast<double>(image.width) * image.height;
  if (pixels <= drawn_px_) return;
  const RendererInfo info = renderer_info();
  const bool is_possible = std::max(image.width, image.height) <= info.max_side_px;  // else the pass says so
  if (is_possible && draws_in_memory(info)) {
    check_memory(kBytesPerPixel * pixels, where, fmt::format("drawing {} x {} px", image.width, image.height),
                 instead);
  }
  drawn_px_ = pixels;
}

void Pipeline::keep_frames(size_t count) {
  for (const auto& node : flow_.nodes()) node->keep_frames(count);
}

void Pipeline::forget_results() {
  drawn_px_ = 0;
  for (const auto& node : flow_.nodes()) node->forget();
  pictures_.clear();
  if (supersampler_) supersampler_->forget_results();
  pool_user_.free_idle();
}

std::vector<std::string> Pipeline::pass_names() const {
  std::vector<std::string> names;
  for (const auto& node : flow_.nodes()) names.emplace_back(node->name());
  names.emplace_back("picture");
  return names;
}

std::map<std::string, StageCount> Pipeline::counts() const {
  std::map<std::string, StageCount> counts;
  for (const auto& node : flow_.nodes()) counts.emplace(node->name(), node->count());
  StageCount& pictures = counts["picture"];
  for (const auto& [buffer, stage] : pictures_) {
    pictures.runs += stage.count().runs;
    pictures.reuses += stage.count().reuses;
  }
  return counts;
}

std::vector<Program*> Pipeline::programs() {
  std::vector<Program*> programs;
  for (const auto& node : flow_.nodes()) {
    for (Program* program : node->programs()) programs.push_back(program);
  }
  programs.push_back(&picture_pass().program());
  programs.push_back(&box_filter().program());
  return programs;
}

bool Pipeline::reload_changed_shaders() {
  bool any = false;
  for (Program* program : programs()) any |= program->reload_if_changed(flow_.generated());
  if (supersampler_) any |= supersampler_->reload_changed_shaders();
  return any;
}

std::string Pipeline::shader_problem() {
  for (const Program* program : programs()) {
    if (!program->problem().empty()) return program->problem();
  }
  return "";
}

Shown Frame::show(BufferName buffer) const {
  ImageParams drawn = settings().image;
  drawn.width = state_->window.width;
  drawn.height = state_->window.height;
  pipeline_->check_room(drawn);
  const PoolUser::Scope scope(pipeline_->pool_user_);
  return pipeline_->flow_.node_of(buffer).show(*state_, buffer);
}

void Frame::draw(BufferName buffer) const {
  show(buffer);
  throw_gl_errors(std::string(name_of(buffer)));
}

template <class Tag>
GivenValue Frame::enlarged_value() const {
  const int times = settings().image.supersample;
  const Key key = KeyBuilder().add("enlarged").add(key_of<Tag>()).add(std::to_string(times)).key();
  return {typeid(Tag), key, std::make_shared<const Strokes>(inkbench::enlarged(*value<Tag>(), times))};
}

/// Curves and strokes have no resolution: what is drawn larger are those of the picture's own size, so that
/// they stay what they are from frame to frame.
std::vector<GivenValue> Frame::enlarged_strokes(BufferName buffer) const {
  if (buffer == BufferName::curves) return {enlarged_value<CurveLinesPass>()};
  const bool with_ink = buffer == BufferName::final || buffer == BufferName::coverage;
  if (buffer == BufferName::strokes || (with_ink && draws_strokes(settings())))
    return {enlarged_value<StrokesPass>()};
  return {};
}

Texture Frame::supersampled(BufferName buffer, const PictureView& view) const {
  pipeline_->check_room(settings().image);
  const Image visible = value<VisibleRangePass>()->read(0, 2);
  std::vector<GivenValue> given = enlarged_strokes(buffer);
  const PoolUser::Scope pool_scope(pipeline_->pool_user_);
  const PassScope pass_scope(pipeline_->flow_.observer(), "picture");
  return pipeline_->supersampler().draw(settings(), {visible.at(0, 0, 0), visible.at(0, 0, 1)},
                                        std::move(given), buffer, view, pipeline_->box_filter(),
                                        pipeline_->tile_px_);
}

Picture Frame::picture(BufferName buffer) const {
  const PictureView view = view_of(settings().display, buffer, std::nullopt);
  if (is_supersampled(settings(), buffer)) {
    Picture picture = supersampled(buffer, view).read_picture();
    throw_gl_errors(std::string(name_of(buffer)));
    return picture;
  }
  const Shown shown = show(buffer);
  if (shown.texture == nullptr) return shown.picture();
  const PoolUser::Scope scope(pipeline_->pool_user_);
  Picture picture = pipeline_->picture_pass().run(view, *shown.texture).read_picture();
  throw_gl_errors(std::string(name_of(buffer)));
  return picture;
}

PictureTexture Frame::picture_texture(BufferName buffer, const std::optional<ShownRange>& range) const {
  PicturePass& pass = pipeline_->picture_pass();
  const PictureView view = view_of(settings().display, buffer, range);
  const bool larger = is_supersampled(settings(), buffer);
  const Key key = picture_key_of(buffer, view);
  const Shown shown = larger ? Shown{} : show(buffer);
  const Texture& texture = pipeline_->pictures_[buffer].get(key, [&] {
    if (larger) return supersampled(buffer, view);
    const PoolUser::Scope pool_scope(pipeline_->pool_user_);
    const PassScope pass_scope(pipeline_->flow_.observer(), "picture");
    return pass.run(view, *shown.texture);
  });
  throw_gl_errors(std::string(name_of(buffer)));
  return {&texture, key};
}

Image Frame::raw(BufferName buffer) const {
  const Shown shown = show(buffer);
  Image image = shown.texture == nullptr
                    ? shown.raw()
                    : shown.texture->read(buffer.info().first_channel, buffer.info().channels);
  throw_gl_errors(std::string(name_of(buffer)));
  return image;
}

Image Frame::raw_part(BufferName buffer, int x, int y, int width_px, int height_px) const {
  const Shown shown = show(buffer);
  if (shown.texture == nullptr) return part_of(shown.raw(), x, y, width_px, height_px);
  const BufferInfo& info = buffer.info();
  Image image = shown.texture->read_part(x, y, width_px, height_px, info.first_channel, info.channels);
  throw_gl_errors(std::string(name_of(buffer)));
  return image;
}

Image Frame::pixel(BufferName buffer, int x, int y) const {
  return raw_part(buffer, x, y, 1, 1);
}

std::vector<DrawItem> Frame::draw_items() const {
  return inkbench::draw_items(settings(), *value<MeshesPass>());
}

LineRequest Frame::line_request() const {
  return ReferencePass::request(pipeline_->flow_, *state_);
}

std::vector<UsedFile> Frame::used_files() const {
  return inkbench::used_files(settings(), pipeline_->meshes());
}

Key Frame::key(BufferName buffer) const {
  return state_->keys[pipeline_->flow_.node_of(buffer).index()];
}

Key Frame::picture_key_of(BufferName buffer, const PictureView& view) const {
  const bool larger = is_supersampled(settings(), buffer);
  const Program& program = larger ? pipeline_->box_filter().program() : pipeline_->picture_pass().program();
  return inkbench::picture_key(view, key(buffer), program.key(), larger ? settings().image.supersample : 1);
}

Key Frame::picture_key(BufferName buffer) const {
  return picture_key_of(buffer, view_of(settings().display, buffer, std::nullopt));
}

Key Frame::key() const {
  KeyBuilder key;
  key.add(pipeline_->picture_pass().program().key()).add(group_text(settings().display));
  for (const Key& node : state_->keys) key.add(node);
  if (settings().image.supersample > 1) {
    key.add(pipeline_->box_filter().program().key())
        .add(fmt::format("supersampled {}", settings().image.supersample));
  }
  return key.key();
}

int Frame::cost_after(const Frame& other) const {
  int cost = 0;
  for (const auto& node : pipeline_->flow_.nodes()) {
    if (state_->keys[node->index()] != other.state_->keys[node->index()]) cost += node->cost();
  }
  return cost;
}

}  // namespace inkbench
