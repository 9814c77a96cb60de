"""Finds the names in C and C++ sources that a program declares, and those that it uses.

The module has no compiler: a name counts as declared if it stands after a type, in an enum or after
#define.  That is enough to tell a program's own names from those of its surroundings.
"""
import re

KEYWORDS = set("""
asm auto bool break case catch char class const const_cast continue default delete do double dynamic_cast else enum
explicit export extern false float for friend goto if inline int long mutable namespace new operator private protected
public register reinterpret_cast return short signed sizeof static static_cast struct switch template this throw true
try typedef typeid typename union unsigned using virtual void volatile wchar_t while""".split())
# Words after which an expression follows, not a declared name.
EXPRESSION = set("return else case goto new delete throw sizeof do typeid and or not".split())
BUILTIN = set("bool char const double float int long short signed unsigned void wchar_t struct class enum".split())

TOKEN = re.compile(r"[A-Za-z_]\w*|::|->|\d[\w.]*|[^\s\w]")


class Source:
    """The tokens of a source as (text, line), its includes, and the macros that it defines."""

    def __init__(self, text):
        self.includes = []  # (line, "<stdio.h>")
        self.defined = {}  # {macro, or parameter of a macro: line}
        text = self._without_attributes(self._without_comments(text))
        self.tokens = []
        joined = text.replace("\\\n", "  ")
        for number, line in enumerate(joined.split("\n"), 1):
            directive = re.match(r"\s*#\s*(\w+)\s*(.*)", line)
            if directive:
                line = self._directive(number, *directive.groups())
            line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])*\'', " 0 ", line)
            self.tokens += [(word, number) for word in TOKEN.findall(line)]

    @staticmethod
    def _without_comments(text):
        def blank(match):
            found = match.group(0)
            return found if found[0] in "\"'" else "\n" * found.count("\n") + " "
        return re.sub(r'"(\\.|[^"\\\n])*"|\'(\\.|[^\'\\\n])*\'|/\*.*?\*/|//[^\n]*', blank, text, flags=re.S)

    @staticmethod
    def _without_attributes(text):
        """Removes __attribute__ and __asm__, because their words are no names of the program."""
        return re.sub(r"__attribute__\s*\(\((\([^()]*\)|[^()])*\)\)|__asm__\s*\([^()]*\)",
                      lambda match: "\n" * match.group(0).count("\n"), text)

    def _directive(self, number, kind, rest):
        """Keeps includes and macros; returns the rest of the line that can contain names."""
        if kind in ("include", "include_next"):
            self.includes.append((number, rest.strip()))
            return ""
        if kind == "define":
            macro = re.match(r"(\w+)(\(([^)]*)\))?(.*)", rest)
            for name in [macro.group(1), *re.findall(r"\w+", macro.group(3) or "")]:
                self.defined.setdefault(name, number)
            return macro.group(4)
        return "" if kind in ("ifdef", "ifndef", "undef", "endif", "else", "error", "pragma", "line") else rest

    def declared(self):
        return set(self.declarations())

    def declarations(self):
        """Returns {name: line of its first declaration}."""
        names = dict(self.defined)
        words = [word for word, _ in self.tokens]
        enum_depth, depth = [], 0
        for i, word in enumerate(words):
            if word == "{":
                depth += 1
                if "enum" in words[max(0, i - 3):i]:
                    enum_depth.append(depth)
            elif word == "}":
                if enum_depth and enum_depth[-1] == depth:
                    enum_depth.pop()
                depth -= 1
            elif self._is_name(word) and i > 0:
                in_enum = enum_depth and enum_depth[-1] == depth and words[i - 1] in "{,"
                if in_enum or self._follows_type(words, i):
                    for name in [word, *self._others(words, i)]:
                        names.setdefault(name, self.tokens[i][1])
        return names

    @staticmethod
    def _is_name(word):
        return (word[0].isalpha() or word[0] == "_") and word not in KEYWORDS

    @classmethod
    def _is_type(cls, word):
        return word in BUILTIN or (cls._is_name(word) and (word[0].isupper() or word in TYPE_NAMES))

    @classmethod
    def _follows_type(cls, words, i):
        before = words[i - 1]
        if before == "(" and words[i - 2] in DECLARING_MACROS:
            return True
        if before == "*" and words[i - 2] == "(" and words[i + 1:i + 3] == [")", "("]:
            return True  # such as int (*function)(int)
        if before[0].isalpha() or before[0] == "_":
            return before not in EXPRESSION
        if before in "*&" and words[i + 1:i + 2] and words[i + 1] in ";,)=([:{":
            at = i - 1
            while at > 0 and words[at] in ("*", "&", "const"):
                at -= 1
            return cls._is_type(words[at]) or words[at] == ">"
        if before == ">":
            return cls._template_before(words, i - 1)
        return False

    @staticmethod
    def _template_before(words, at):
        depth = 0
        while at >= 0 and words[at] not in ";{}()":
            depth += words[at] == ">"
            depth -= words[at] == "<"
            if depth == 0:
                return words[at - 1] in TEMPLATES
            at -= 1
        return False

    @classmethod
    def _others(cls, words, i):
        """Returns the names that follow the first: b and c in `int a, *b = 0, c[3];`."""
        names, depth = set(), 0
        for j in range(i + 1, min(len(words) - 2, i + 400)):
            word = words[j]
            depth += word in "([{"
            depth -= word in ")]}"
            if depth < 0 or (depth == 0 and word in ";{"):
                break
            if depth == 0 and word == ",":
                k = j + 1
                while words[k] in "*&":
                    k += 1
                if cls._is_name(words[k]) and words[k + 1] in ";,=[:":
                    names.add(words[k])
        return names

    def uses(self):
        """Yields (name, line, qualifier, is_call) for every use of a name.

        The qualifier is "." for a member, "::" for ::name, else the name before "::", or "".
        """
        words = [word for word, _ in self.tokens]
        for i, (word, line) in enumerate(self.tokens):
            if not self._is_name(word):
                continue
            before = words[i - 1] if i else ""
            qualifier = ""
            if before in (".", "->"):
                qualifier = "."
            elif before == "::":
                qualifier = words[i - 2] if i > 1 and self._is_name(words[i - 2]) else "::"
            is_call = words[i + 1:i + 2] == ["("] and not (i and self._follows_type(words, i))
            yield word, line, qualifier, is_call


TYPE_NAMES = set("byte sbyte word sword longword slongword size_t string int16 int32 uint16 uint32 boolean".split())
DECLARING_MACROS = {"COMPILE_TIME_CHECK"}  # parameters: (name, condition)
TEMPLATES = set("vector list deque map multimap set multiset pair queue stack bitset auto_ptr".split())
