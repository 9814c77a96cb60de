#include "openr/render/gl_program.h"

#include <stdexcept>

namespace openr_host::render {
namespace {

GLuint Compile(GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  char log[1024] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw std::runtime_error(std::string("a shader does not compile: ") + log);
}

}  // namespace

GlProgram::GlProgram(const char* vertex_text, const char* fragment_text) {
  const GLuint vertex = Compile(GL_VERTEX_SHADER, vertex_text);
  const GLuint fragment = Compile(GL_FRAGMENT_SHADER, fragment_text);
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (good == 0) throw std::runtime_error("the shaders do not link");
}

GlProgram::~GlProgram() { glDeleteProgram(program_); }

void GlProgram::Set(const char* name, int value) const {
  glUniform1i(glGetUniformLocation(program_, name), value);
}

void GlProgram::Set(const char* name, float value) const {
  glUniform1f(glGetUniformLocation(program_, name), value);
}

void GlProgram::Set(const char* name, const Eigen::Vector3f& value) const {
  glUniform3fv(glGetUniformLocation(program_, name), 1, value.data());
}

void GlProgram::Set(const char* name, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(glGetUniformLocation(program_, name), 1, GL_FALSE, value.data());
}

DepthTarget::DepthTarget(int size_px) : size_px_(size_px) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size_px, size_px, 0, GL_DEPTH_COMPONENT,
               GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  // Makes OpenGL compare distances from the light when a shader reads the texture: the distance
  // that the shader passes and the distance in the texture.  The shader gets 1 if its point is lit,
  // or 0 if its point is in shadow.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!complete) throw std::runtime_error("this OpenGL cannot draw into a depth texture");
}

DepthTarget::~DepthTarget() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &texture_);
}

void DepthTarget::Bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, size_px_, size_px_);
  glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace openr_host::render
