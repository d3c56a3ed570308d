#include "app/window/workbench.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/window/word_list.h"
#include "pipeline/base/error.h"
#include "pipeline/base/log.h"
#include "pipeline/settings/settings_file.h"

namespace inkbench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Every parameter is asked whether it accepts its value. Errors (input): one does not.
Settings checked(Settings settings) {
  for (const Param& param : list_params(settings)) param.set(param.value(), "");
  return settings;
}

}  // namespace

Workbench::Workbench(const Session& session, Keeping& kept)
    : keeping(kept),
      layout(session.layout),
      history_(session.settings),
      origins_{origin_in(session.scene, session.settings)},
      wake_seconds_(kNever) {
  set_log_sink([this](const std::string& text) { log.add(Severity::note, text); });
  pictures.pipeline().observe(&timer);
  tiles.observe(&window_timer);
  on_study = [this](const OpenedFile& file) { studies.open_spec(file.path); };
}

Workbench::~Workbench() {
  set_log_sink({});
}

template <class Change>
bool Workbench::apply(const Change& change, const std::string& step) {
  Settings next = settings();
  try {
    change(next);
  } catch (const Error& error) {
    set_problem(ProblemKind::input, error.what());
    return false;
  }
  dismiss(ProblemKind::input);
  history_.record(std::move(next), step);
  ++revision_;
  return true;
}

void Workbench::change(const std::string& key, const Value& value) {
  apply([&](Settings& next) { find_param(next, key, "").set(value, ""); });
}

void Workbench::change_text(const std::string& key, const std::string& text) {
  apply([&](Settings& next) { set_param_text(next, key, text, ""); });
}

void Workbench::reset(const std::string& key) {
  Settings from = baseline();
  if (has_param(from, key)) change(key, find_param(from, key, "").value());
}

void Workbench::replace(const Settings& settings, const std::string& step) {
  apply([&](Settings& next) { next = checked(settings); }, step);
}

void Workbench::begin_edit() {
  if (!is_editing()) history_.begin_edit();
}

void Workbench::end_edit() {
  history_.end_edit();
  ++revision_;
}

void Workbench::undo() {
  if (history_.can_undo()) go_to_step(history_.position() - 1);
}

void Workbench::redo() {
  if (history_.can_redo()) go_to_step(history_.position() + 1);
}

void Workbench::go_to_step(size_t position) {
  if (is_editing()) return;  // what is held by the mouse goes on
  history_.go_to(position);
  dismiss(ProblemKind::input);
  ++revision_;
}

Key Workbench::state_to_draw(const Settings& settings) const {
  return KeyBuilder().add(settings_text(settings)).add(std::to_string(files_revision_)).key();
}

/// Works anything out only where something changed, or waits for the levels of a mesh.
const Settings& Workbench::update_target() {
  const bool is_level = target_.settings.mesh == settings().mesh;
  if (target_.revision == revision_ && target_.files_revision == files_revision_ && is_level)
    return target_.settings;
  target_ = {ladders.drawable(pictures.pipeline().meshes(), settings()), revision_, files_revision_, {}, {}};
  target_.state = state_to_draw(target_.settings);
  return target_.settings;
}

void Workbench::refresh() {
  const Settings& target = update_target();
  const Key state = target_.state;
  if (drawn_state_ != state) ++drawn_changes_;
  drawn_state_ = state;
  timer.begin_frame(drawn_changes_);
  window_timer.begin_frame(frame_times.frames);
  if (failed_ == state) return;
  try {
    const bool hurry = is_editing() || frame_times.frames == 0;
    if (!target_.frame) target_.frame = pictures.pipeline().at(target);
    const Frame& frame = *target_.frame;
    pictures.refresh(frame, wanted_buffers(), view.filled.value_or(view.selected));
    const bool judges = layout.show_inspector && layout.side_page == SidePage::judge;
    judge.refresh(pictures, frame,
                  {judges || layout.overlay == Overlay::matches, layout.overlay == Overlay::reference},
                  hurry);
    drawn_ = frame;
    if (target.mesh == settings().mesh) last_good_ = settings();
    failed_.reset();
    dismiss(ProblemKind::drawing);
  } catch (const std::bad_alloc&) {
    failed_ = state;
    set_problem(ProblemKind::drawing, "out of memory; choose a smaller image or mesh");
  } catch (const std::exception& error) {
    failed_ = state;
    set_problem(ProblemKind::drawing, error.what());
  }
}

bool Workbench::take_news() {
  const bool lines = pictures.reference().take_news();
  const bool measures = judge.take_news();
  const bool levels = ladders.take_news();
  return lines || measures || levels;
}

/// What the files that the settings name hold, or why they cannot be read.
std::string Workbench::files_state() {
  try {
    return pictures.pipeline().at(settings()).key().text();
  } catch (const Error& error) {
    return error.what();
  }
}

/// Of all programs: mending one does not mend another.
std::string Workbench::shader_problem() {
  for (const std::string& problem :
       {pictures.pipeline().shader_problem(), tiles.shader_problem(), wires.shader_problem()}) {
    if (!problem.empty()) return problem;
  }
  return "";
}

bool Workbench::reload_shaders() {
  try {
    bool changed = pictures.pipeline().reload_changed_shaders();
    changed |= tiles.reload_if_changed();
    changed |= wires.reload_if_changed();
    if (!changed) return false;
    tell(Severity::note, "shaders reloaded");
  } catch (const Error& error) {
    set_problem(ProblemKind::shader, error.what());
    return true;
  }
  const std::string problem = shader_problem();
  if (problem.empty()) dismiss(ProblemKind::shader);
  if (!problem.empty()) set_problem(ProblemKind::shader, problem);
  return true;
}

bool Workbench::poll_files() {
  const long told = log.revision();
  bool changed = reload_shaders();
  changed |= take_files_state();
  if (changed) ++files_revision_;
  return changed || log.revision() != told;
}

/// Whether the files hold something else than at the last look, which must have been for the same settings:
/// what changed settings change is not a file's doing.
bool Workbench::take_files_state() {
  const std::string last_settings = std::exchange(files_settings_, settings_text(settings()));
  const std::string last_state = std::exchange(files_state_, files_state());
  return last_settings == files_settings_ && last_state != files_state_;
}

bool Workbench::is_listed(BufferName buffer) const {
  return !has_word(layout.hidden_buffers, name_of(buffer));
}

void Workbench::set_listed(BufferName buffer, bool listed) {
  layout.hidden_buffers = with_word(layout.hidden_buffers, name_of(buffer), !listed);
}

std::vector<BufferName> Workbench::wanted_buffers() const {
  std::vector<BufferName> wanted;
  if (view.comparison.active) {
    for (const ComparedPicture& side : {view.comparison.a, view.comparison.b}) {
      if (!side.pinned) wanted.push_back(side.buffer);
    }
    return wanted;
  }
  if (view.filled) return {*view.filled};
  for (const BufferName buffer : all_buffers()) {
    if (is_listed(buffer)) wanted.push_back(buffer);
  }
  return wanted;
}

void Workbench::pin() {
  if (!drawn_) return;
  try {
    pictures.pin(*drawn_);
    tell(Severity::note, "pinned this state");
  } catch (const Error& error) {
    set_problem(ProblemKind::drawing, error.what());
  }
}

void Workbench::tell(Severity severity, const std::string& text) {
  log.add(severity, text);
}

void Workbench::set_problem(ProblemKind kind, const std::string& text) {
  const auto found = problems_.find(kind);
  if (found == problems_.end() || found->second != text) tell(Severity::error, text);
  problems_[kind] = text;
}

/// As far as the files decide it.
bool Workbench::can_be_drawn(const Settings& settings) {
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
const Workbench::WayBack& Workbench::way_back() {
  if (way_back_from_ == failed_ || is_editing()) return way_back_;
  way_back_from_ = failed_;
  way_back_ = {};
  if (!failed_) return way_back_;
  way_back_.to_last_good = last_good_ && !same_settings(*last_good_, settings()) && can_be_drawn(*last_good_);
  way_back_.step = history_.find_back([&](const Settings& before) {
    return way_back_.to_last_good ? same_settings(before, *last_good_) : can_be_drawn(before);
  });
  return way_back_;
}

bool Workbench::can_go_back() {
  return way_back().step || way_back().to_last_good;
}

void Workbench::go_back() {
  const WayBack way = way_back();
  if (way.step) return go_to_step(*way.step);
  if (way.to_last_good) replace(*last_good_, "back to what could be drawn");
}

void Workbench::wake_in(double seconds) {
  wake_seconds_ = std::min(wake_seconds_, seconds);
}

double Workbench::take_wake_seconds() {
  return std::exchange(wake_seconds_, kNever);
}

}  // namespace inkbench
