#include "app/window/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace inkbench {
namespace {

constexpr double kNearestPole = 1.0;  // degrees between the view and the up direction

struct Axes {
  glm::dvec3 right, up, forward;
  double distance;
};

Axes axes_of(const CameraParams& camera) {
  const glm::dvec3 to_target = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
  const double distance = glm::length(to_target);
  const glm::dvec3 forward = to_target / std::max(distance, 1e-9);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  return {right, glm::cross(right, forward), forward, distance};
}

}  // namespace

CameraParams orbited(const CameraParams& camera, double right_deg, double up_deg) {
  const Axes axes = axes_of(camera);
  const glm::dvec3 pole = glm::normalize(glm::dvec3(camera.up));
  const double from_pole = glm::degrees(std::acos(std::clamp(glm::dot(-axes.forward, pole), -1.0, 1.0)));
  const double up = from_pole - std::clamp(from_pole - up_deg, kNearestPole, 180.0 - kNearestPole);
  glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(right_deg), pole);
  turn = glm::rotate(turn, glm::radians(-up), axes.right);
  CameraParams moved = camera;
  moved.eye = glm::dvec3(camera.target) - glm::dvec3(turn * glm::dvec4(axes.forward, 0.0)) * axes.distance;
  return moved;
}

CameraParams panned(const CameraParams& camera, double right, double down) {
  const Axes axes = axes_of(camera);
  const double height = 2.0 * axes.distance * std::tan(glm::radians(camera.fov) / 2.0);
  const glm::dvec3 shift = (axes.up * down - axes.right * right) * height;
  CameraParams moved = camera;
  moved.eye = glm::dvec3(camera.eye) + shift;
  moved.target = glm::dvec3(camera.target) + shift;
  return moved;
}

CameraParams dollied(const CameraParams& camera, double factor) {
  const Axes axes = axes_of(camera);
  const double distance = std::max(axes.distance * factor, camera.near * 1.5);
  CameraParams moved = camera;
  moved.eye = glm::dvec3(camera.target) - axes.forward * distance;
  return moved;
}

}  // namespace inkbench
