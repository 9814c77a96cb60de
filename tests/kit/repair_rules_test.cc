// Tests of the repairs for errors of today's compiler; build_test.cc tests them in a build.
#include "kit/repair_rules.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace openr_host {
namespace {

// `text` after the repair of an error at the first '@', which is taken out.
std::string Repaired(std::string text, const std::string& message,
                     const std::vector<std::string>& headers = {}) {
  const size_t at = text.find('@');
  text.erase(at, 1);
  const std::string before = text.substr(0, at);
  const int line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  const int column = static_cast<int>(at - (before.rfind('\n') + 1)) + 1;
  std::vector<Edit> edits = RepairOf({message, "a.cc", line, column}, text, headers);
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
  for (const Edit& edit : edits) text.replace(edit.begin, edit.end - edit.begin, edit.text);
  return text;
}

constexpr char kUndeclaredI[] = "'i' was not declared in this scope";

TEST(RepairRulesTest, ALoopsVariableLivesUntilTheEndOfTheBlock) {
  EXPECT_EQ(Repaired("{ for (int i = 0; i < 3; i++) f(); return @i; }", kUndeclaredI),
            "{ int i = 0; for (         ; i < 3; i++) f(); return i; }");
}

TEST(RepairRulesTest, ALaterLoopMeansTheSameVariable) {
  EXPECT_EQ(Repaired("{ for (int i = 0;;) { } g(@i); for (int i = 7;;) { } h(i); }", kUndeclaredI),
            "{ int i = 0; for (         ;;) { } g(i); for (    i = 7;;) { } h(i); }");
}

TEST(RepairRulesTest, ALoopOfABlockThatIsOverIsNotMeant) {
  const std::string text = "{ if (x) { for (int i = 0;;) { } } return i; }";
  std::string marked = text;
  marked.insert(text.rfind('i'), "@");
  EXPECT_EQ(Repaired(marked, kUndeclaredI), text);
}

TEST(RepairRulesTest, ALoopThatIsABranchIsLeftAlone) {
  const std::string text = "{ if (x) for (int i = 0;;) { } return @i; }";
  EXPECT_EQ(Repaired(text, kUndeclaredI), "{ if (x) for (int i = 0;;) { } return i; }");
}

TEST(RepairRulesTest, WordsInCommentsAndStringsAreNotCode) {
  EXPECT_EQ(Repaired("{ /* for (int i = 0;;) */ \"for (int i\"; return @i; }", kUndeclaredI),
            "{ /* for (int i = 0;;) */ \"for (int i\"; return i; }");
}

TEST(RepairRulesTest, ARepeatedParameterOfADeclarationLosesItsName) {
  EXPECT_EQ(Repaired("void f(int a, int @a) const;", "redefinition of 'int a'"),
            "void f(int a, int  ) const;");
  EXPECT_EQ(Repaired("void f(int a, int @a) { }", "redefinition of 'int a'"),
            "void f(int a, int a) { }");
}

TEST(RepairRulesTest, ATypeOfTheSdkIsNotDeclaredAgain) {
  EXPECT_EQ(Repaired("typedef unsigned long @uint32; int x;",
                     "conflicting declaration 'typedef long unsigned int uint32'"),
            "                            ; int x;");
}

TEST(RepairRulesTest, AnInheritedNameOfATemplateIsFoundThroughThis) {
  EXPECT_EQ(Repaired("template<class T> struct D : B<T> { int f() { return @v; } };",
                     "'v' was not declared in this scope"),
            "template<class T> struct D : B<T> { int f() { return this->v; } };");
  EXPECT_EQ(
      Repaired("template<class T> int f() { return @v; }", "'v' was not declared in this scope"),
      "template<class T> int f() { return v; }");
}

TEST(RepairRulesTest, MinimumAndMaximumAreSaidInAnotherWay) {
  const char* const message = "expected primary-expression before '?' token";
  EXPECT_EQ(Repaired("x = a <@? b;", message), "x = a  <openr_old::minimum>  b;");
  EXPECT_EQ(Repaired("a >@?= b;", message), "a  <openr_old::set_maximum>  b;");
}

TEST(RepairRulesTest, AHeadersNameGetsItsCaseAndItsSlashes) {
  EXPECT_EQ(Repaired("#include @\"Sub\\NAME.H\"\n", "Sub\\NAME.H: No such file or directory",
                     {"/p/other/name.h", "/p/src/sub/Name.h"}),
            "#include \"sub/Name.h\"\n");
}

TEST(RepairRulesTest, LinesNeverMove) {
  EXPECT_EQ(Repaired("typedef\n  unsigned long\n  @uint32;\nint x;",
                     "conflicting declaration 'typedef long unsigned int uint32'"),
            "       \n               \n        ;\nint x;");
}

}  // namespace
}  // namespace openr_host
