// Shaders and textures of OpenGL 2.1, owned.
#pragma once

// GL_GLEXT_PROTOTYPES comes from the build.
#include <GL/gl.h>
#include <GL/glext.h>

#include <Eigen/Core>
#include <string>

namespace openr_host::render {

// Throws std::runtime_error with the compiler's words when a shader does not compile.
class GlProgram {
 public:
  GlProgram(const char* vertex_text, const char* fragment_text);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void Use() const { glUseProgram(program_); }

  // Of the program in use.
  void Set(const char* name, int value) const;
  void Set(const char* name, float value) const;
  void Set(const char* name, const Eigen::Vector3f& value) const;
  void Set(const char* name, const Eigen::Matrix4f& value) const;

 private:
  GLuint program_ = 0;
};

// A square picture of distances, drawn into between Bind() and the next Bind...().
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
