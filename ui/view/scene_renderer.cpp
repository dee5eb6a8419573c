// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene_renderer.hpp"

#include <QOpenGLContext>
#include <utility>

#include "ui/view/appearance.hpp"

namespace footfall::ui {
namespace {

QString buildProgram(QOpenGLShaderProgram& program, const QString& name) {
  const QString path = QStringLiteral(":/shaders/") + name;
  if (program.addShaderFromSourceFile(QOpenGLShader::Vertex, path + QStringLiteral(".vert")) &&
      program.addShaderFromSourceFile(QOpenGLShader::Fragment, path + QStringLiteral(".frag")) && program.link()) {
    return {};
  }
  return QStringLiteral("shader %1: %2; update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1")
      .arg(name, program.log().simplified());
}

}  // namespace

QString SceneRenderer::initialize() {
  initializeOpenGLFunctions();
  for (const auto& [program, name] : {std::pair{&surfaceProgram_, "surface"}, std::pair{&lineProgram_, "line"},
                                      std::pair{&backgroundProgram_, "background"},
                                      std::pair{&cells_.program(), "cell"}, std::pair{&fieldProgram_, "field"}}) {
    const QString problem = buildProgram(*program, QString::fromLatin1(name));
    if (!problem.isEmpty()) return problem;
  }
  whole_.beginWhole();
  emptyArray_.create();
  cells_.initialize();
  batches_.initialize();
  polygonMode_ =
      reinterpret_cast<decltype(polygonMode_)>(QOpenGLContext::currentContext()->getProcAddress("glPolygonMode"));
  // In another context than before, everything has to be made again.
  const SceneContent known = coming_ ? *coming_ : scene_;
  scene_ = {};
  coming_.reset();
  coming().environment = known.environment;
  coming().content = known.content;
  coming().field = known.field;
  coming().sources = known.sources;
  return {};
}

void SceneRenderer::release() {
  scene_ = {};
  coming_.reset();
  cellBorders_.reset();
  if (scaleTexture_ != 0) glDeleteTextures(1, &scaleTexture_);
  scaleTexture_ = 0;
  batches_.release();
  cells_.release();
  for (Picture* picture : {&still_, &next_, &picture_}) picture->reset();
  stillKey_ = {};
  nextKey_ = pictureKey_ = {};
  shownChanges_.clear();
  emptyArray_.destroy();
  for (QOpenGLShaderProgram* program : {&surfaceProgram_, &lineProgram_, &backgroundProgram_, &fieldProgram_}) {
    program->removeAllShaders();
  }
}

// Until its buffers are full, what is there stays.
SceneContent& SceneRenderer::coming() {
  if (!coming_) coming_ = scene_;
  comingMade_ = false;
  return *coming_;
}

void SceneRenderer::setEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  coming().environment = std::move(geometry);
  coming().content = {};
  coming().field = nullptr;
  coming().sources = nullptr;
  afresh_ = true;
}

void SceneRenderer::replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> geometry) {
  coming().environment = std::move(geometry);
}

void SceneRenderer::setContent(ViewContent content) { coming().content = std::move(content); }

void SceneRenderer::setCells(std::shared_ptr<const CellGeometry> geometry, CellColours colours) {
  cells_.setGeometry(std::move(geometry));
  cells_.setColours(std::move(colours));
  marked_ = {};
  bordersPending_ = true;
  dropUnfinished();
}

void SceneRenderer::setCellColours(CellColours colours) {
  cells_.setColours(std::move(colours));
  dropUnfinished();
}

void SceneRenderer::setFieldScale(const FieldScale& scale) {
  fieldScale_ = scale;
  dropUnfinished();
}

void SceneRenderer::setField(std::shared_ptr<const FieldGeometry> field) { coming().field = std::move(field); }

void SceneRenderer::setSources(std::shared_ptr<const NavigationMeshGeometry> sources) {
  coming().sources = std::move(sources);
}

void SceneRenderer::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  batches_.setHiddenLayers(hidden);
  dropUnfinished();
}

// Returns whether it can be shown.
bool SceneRenderer::uploadComing(double ms) {
  if (std::exchange(afresh_, false)) {
    scene_ = {};
    pictureKey_ = nextKey_ = {};
    shownChanges_.clear();
  }
  if (!coming_) return true;
  if (!std::exchange(comingMade_, true)) coming_->makeBatches(batches_, scene_);
  return batches_.upload(ms);
}

void SceneRenderer::uploadBorders() {
  if (!std::exchange(bordersPending_, false)) return;
  cellBorders_ = cells_.geometry() ? batches_.makeLines(cells_.geometry(), cells_.geometry()->borders) : nullptr;
  if (cellBorders_) batches_.uploadNow(*cellBorders_);
}

}  // namespace footfall::ui
