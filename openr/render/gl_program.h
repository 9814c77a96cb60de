// GlProgram and DepthTarget, which own shaders and textures of OpenGL 2.1.
#pragma once

// The build defines GL_GLEXT_PROTOTYPES, so that this header declares the functions for shaders.
#include <GL/gl.h>
#include <GL/glext.h>

#include <Eigen/Core>
#include <string>

namespace openr_host::render {

// A vertex shader and a fragment shader, compiled and linked.  The constructor throws
// std::runtime_error, with the compiler's message, when a shader does not compile.
class GlProgram {
 public:
  GlProgram(const char* vertex_text, const char* fragment_text);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void Use() const { glUseProgram(program_); }

  // Sets the variable `name` of the shaders.  REQUIRES: this program is in use.
  void Set(const char* name, int value) const;
  void Set(const char* name, float value) const;
  void Set(const char* name, const Eigen::Vector3f& value) const;
  void Set(const char* name, const Eigen::Matrix4f& value) const;

 private:
  GLuint program_ = 0;
};

// A square texture for the view from a light: each pixel holds the distance from the light to the
// nearest surface.  After Bind(), OpenGL draws into this texture until something else is bound.
class DepthTarget {
 public:
  explicit DepthTarget(int size_px);
  ~DepthTarget();
  DepthTarget(const DepthTarget&) = delete;
  DepthTarget& operator=(const DepthTarget&) = delete;

  void Bind() const;
  GLuint texture() const { return texture_; }

 private:
  const int size_px_;
  GLuint texture_ = 0;
  GLuint framebuffer_ = 0;
};

}  // namespace openr_host::render
