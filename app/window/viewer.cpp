// SPDX-License-Identifier: MIT
#include "app/window/viewer.h"

#include <new>

#include "app/window/listed_buffers.h"
#include "pipeline/base/error.h"
#include "pipeline/passes/curves/curves.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {

Viewer::Viewer(Document& document, Problems& problems, const WindowLayout& layout, const ViewState& view,
               News& news)
    : pictures(news),
      judge(news),
      ladders(news),
      disk(document, problems, pictures.pipeline(), judge, tiles, wires),
      document_(document),
      problems_(problems),
      layout_(layout),
      view_(view) {
  pictures.pipeline().observe(&timer);
  tiles.observe(&window_timer);
}

Key Viewer::state_to_draw(const Settings& settings) const {
  return KeyBuilder().add(settings_text(settings)).add(std::to_string(disk.revision())).key();
}

/// Works anything out only where something changed, or while the levels of a mesh are made.
void Viewer::update_target() {
  const bool is_level = target_.settings.mesh == document_.settings().mesh;
  const bool was_turning = target_.has_past && !document_.is_editing();
  if (!was_turning && target_.revision == document_.revision() && target_.files_revision == disk.revision() &&
      is_level)
    return;
  target_ = {ladders.drawable(pictures.pipeline().meshes(), document_.settings()),
             document_.revision(),
             disk.revision(),
             {},
             {}};
  target_.state = state_to_draw(target_.settings);
}

/// While the camera is dragged paint stays where it was on the lines. At rest pictures are those of their
/// settings alone, whatever was seen before: the ones that files get.
Frame Viewer::next_frame() {
  Pipeline& pipeline = pictures.pipeline();
  if (document_.is_editing() && drawn_) {
    Settings turned = drawn_->settings();
    turned.camera = target_.settings.camera;
    target_.has_past = same_settings(turned, target_.settings);
  }
  return target_.has_past ? pipeline.at(target_.settings, drawn_->without_past())
                          : pipeline.at(target_.settings);
}

void Viewer::draw(const Frame& frame) {
  const bool hurry = document_.is_editing() || frame_times.frames == 0;
  pictures.refresh(frame, wanted_buffers(layout_, view_), looked_at(view_));
  const bool judges = layout_.show_inspector && layout_.side_page == SidePage::judge;
  judge.refresh(pictures, frame,
                {judges || layout_.overlay == Overlay::matches, layout_.overlay == Overlay::reference,
                 layout_.overlay == Overlay::causes},
                hurry);
}

void Viewer::fail(const Key& state, const std::string& why) {
  failed_ = state;
  problems_.set(ProblemKind::drawing, why);
}

void Viewer::refresh() {
  update_target();
  const Key state = target_.state;
  if (drawn_state_ != state) ++drawn_changes_;
  drawn_state_ = state;
  timer.begin_frame(drawn_changes_);
  window_timer.begin_frame(frame_times.frames);
  if (failed_ == state) return;
  try {
    if (!target_.frame) target_.frame = next_frame();
    draw(*target_.frame);
    drawn_ = target_.frame;
    if (target_.settings.mesh == document_.settings().mesh) last_good_ = document_.settings();
    failed_.reset();
    problems_.dismiss(ProblemKind::drawing);
  } catch (const std::bad_alloc&) {
    fail(state, "out of memory; choose a smaller image or mesh");
  } catch (const std::exception& error) {
    fail(state, error.what());
  }
}

const Explanation& Viewer::explain(int x, int y) {
  const Key edges = drawn_->key(BufferName::lines);
  const Key key = KeyBuilder().add(edges).add(std::to_string(x)).add(std::to_string(y)).key();
  if (key == explained_) return explanation_;
  explanation_ = explain_pixel(*drawn_, x, y);
  explained_ = key;
  return explanation_;
}

const Explanation& Viewer::explain_pinned(int x, int y) {
  const KeptMaps& maps = *pictures.pinned_maps();
  const Key lines = pictures.shown(maps.decided, true).key;
  const Key key = KeyBuilder().add(lines).add(std::to_string(x)).add(std::to_string(y)).key();
  if (key == explained_) return explanation_;
  explanation_ = explain_pixel(maps, x, y);
  explained_ = key;
  return explanation_;
}

const Curves& Viewer::curves() {
  const Key key = drawn_->key_of<CurvesPass>();
  if (curves_ && curves_key_ == key) return *curves_;
  curves_ = drawn_->value<CurvesPass>();
  curves_key_ = key;
  return *curves_;
}

void Viewer::pin() {
  if (!drawn_) return;
  try {
    pictures.pin(*drawn_);
    problems_.tell(Severity::note, "pinned this state");
  } catch (const Error& error) {
    problems_.set(ProblemKind::drawing, error.what());
  }
}

/// As far as the files decide it.
bool Viewer::can_be_drawn(const Settings& settings) {
  try {
    pictures.pipeline().at(settings);
  } catch (const Error&) {
    return false;
  }
  MeshStore& meshes = pictures.pipeline().meshes();
  for (size_t i = 0; i < settings.models.size(); ++i) {
    const ModelParams& model = settings.models[i];
    if (model.visible && !meshes.can_get(model, level_of(settings, i))) return false;
  }
  return true;
}

/// Found once for each failure, since it reads meshes.
const Viewer::WayBack& Viewer::way_back() {
  if (way_back_from_ == failed_ || document_.is_editing()) return way_back_;
  way_back_from_ = failed_;
  way_back_ = {};
  if (!failed_) return way_back_;
  way_back_.to_last_good =
      last_good_ && !same_settings(*last_good_, document_.settings()) && can_be_drawn(*last_good_);
  way_back_.step = document_.history().find_back([&](const Settings& before) {
    return way_back_.to_last_good ? same_settings(before, *last_good_) : can_be_drawn(before);
  });
  return way_back_;
}

bool Viewer::can_go_back() {
  return way_back().step || way_back().to_last_good;
}

void Viewer::go_back() {
  const WayBack way = way_back();
  if (way.step) return document_.go_to_step(*way.step);
  if (way.to_last_good) document_.replace(*last_good_, "back to what could be drawn");
}

}  // namespace inkbench
