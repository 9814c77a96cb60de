"""Makes mutants of C++ sources: small changes that the tests should notice.

mutants_of() reads a source and returns its mutants.  Comments, texts, preprocessor lines,
assertions and the texts of messages are not changed.  Our layout helps: clang-format puts spaces
around operators with two operands, and none around those of templates, pointers and references.
"""
import collections
import re

# A mutant: `file` and `line` (from 1) say where it is; `original` and `changed` are the code that
# is replaced and its replacement; `begin` and `end` are the places of `original` in the file;
# `text` is the whole line without spaces at its ends, and `occurrence` numbers equal lines from 1.
Mutant = collections.namedtuple("Mutant",
                                "file line original changed begin end text occurrence")
Token = collections.namedtuple("Token", "kind text begin end")

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>^[ \t]*\#(?:[^\n\\]|\\.)*)
  | (?P<text>(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')
  | (?P<number>\d(?:'?[\w.]|(?<=[eE])[+-])*|\.\d+\w*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<operator><=>|<<=|>>=|->\*|\.\.\.|::|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+",
         "*": "/", "/": "*", "&&": "||", "||": "&&", "&": "|", "|": "&", "+=": "-=", "-=": "+=",
         "<<": ">>", ">>": "<<"}
# Calls whose arguments are not changed: assertions, which are not part of the behaviour, and texts.
UNCHANGED_CALLS = re.compile(
    r"ASSERT|REQUIRE|CHECK|Fatal|ThrowUnless|static_assert|COMPILE_TIME_CHECK|OSYSLOG\d?|OSYSPRINT"
    r"|format|format_to|print|TextFormat|printf|snprintf")
# Words with which no statement begins that can be removed.
KEYWORDS = set("""return break continue goto using typedef static constexpr const struct class enum
    union case default if else for while do switch template namespace friend extern public private
    protected operator throw try catch unsigned signed auto virtual inline co_return typename
    """.split())
COMPARISONS = ("<", "<=", ">", ">=", "==", "!=", "&&", "||")
ZEROS = ("0", "nullptr", "true", "false", "rcOK", "oSUCCESS", "sSUCCESS")  # for them 0 is no change
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
OPENING, CLOSING = {"(": ")", "[": "]", "{": "}"}, {")", "]", "}"}


def tokens_of(source):
    """Returns the tokens of `source` without white space, comments and preprocessor lines."""
    found = []
    for match in TOKEN.finditer(source):
        if match.lastgroup in ("comment", "directive") or match.group().isspace():
            continue
        found.append(Token(match.lastgroup, match.group(), match.start(), match.end()))
    return found


def partners(tokens):
    """Returns the index of the closing bracket for each index of an opening one."""
    closing, open_ones = {}, []
    for index, token in enumerate(tokens):
        if token.kind != "operator":
            continue
        if token.text in OPENING:
            open_ones.append(index)
        elif token.text in CLOSING and open_ones:
            closing[open_ones.pop()] = index
    return closing


def next_name(tokens, index):
    return tokens[index].text if index < len(tokens) and tokens[index].kind == "name" else ""


class Maker:
    """Makes the mutants of one source."""

    def __init__(self, file, source):
        self.file, self.source = file, source
        self.tokens = tokens_of(source)
        self.closing = partners(self.tokens)
        self.is_old = file.startswith("objects/")  # C++98
        self.mutants = []
        lines = source.splitlines()
        self.lines = [line.strip() for line in lines]
        self.unchanged = set()  # indices of tokens in UNCHANGED_CALLS and in square brackets [[ ]]
        for index, token in enumerate(self.tokens):
            if token.kind == "name" and UNCHANGED_CALLS.fullmatch(token.text):
                self.unchanged.update(range(index, self.closing.get(index + 1, index) + 1))
            if token.text == "[" and self.tokens[index + 1].text == "[":
                self.unchanged.update(range(index, self.closing.get(index, index) + 1))

    def add(self, begin, end, changed):
        line = self.source.count("\n", 0, begin) + 1
        text = self.lines[line - 1]
        occurrence = self.lines[:line].count(text)
        self.mutants.append(Mutant(self.file, line, self.source[begin:end], changed, begin, end,
                                   text, occurrence))

    def is_spaced(self, token):
        return (self.source[token.begin - 1].isspace()
                and self.source[token.end:token.end + 1].isspace())

    def make(self):
        for index, token in enumerate(self.tokens):
            if index in self.unchanged:
                continue
            self.change_token(token)
            if token.text == "if":
                self.negate_condition(index)
            if token.text == "return":
                self.change_result(index)
        self.remove_statements()
        return sorted(self.mutants, key=lambda mutant: mutant.begin)

    def change_token(self, token):
        text = token.text
        if token.kind == "operator":
            if text in SWAPS and self.is_spaced(token):
                self.add(token.begin, token.end, SWAPS[text])
            elif text in ("++", "--"):
                self.add(token.begin, token.end, "--" if text == "++" else "++")
        elif text in ("true", "false"):
            self.add(token.begin, token.end, "false" if text == "true" else "true")
        elif token.kind == "number":
            integer = re.fullmatch(r"(0[xX][\da-fA-F']+|[\d']+)([uUlL]*)", text)
            if integer:
                digits = integer[1].replace("'", "")
                base = 16 if digits[:2].lower() == "0x" else 10
                value = int(digits, base) + 1
                written = hex(value) if base == 16 else str(value)
                self.add(token.begin, token.end, written + integer[2])
            else:
                self.add(token.begin, token.end, f"({text} + 1)")

    def negate_condition(self, index):
        opening = index + 1
        if self.tokens[opening].text != "(" or opening not in self.closing:
            return
        inner = self.tokens[opening + 1:self.closing[opening]]
        if any(token.text in (";", "=") for token in inner):
            return  # the condition declares a variable
        if self.is_one_equality(inner):
            return  # a swap of '==' and '!=' does the same
        begin, end = inner[0].begin, inner[-1].end
        self.add(begin, end, f"!({self.source[begin:end]})")

    def is_one_equality(self, inner):
        """Returns whether `inner` is one comparison by '==' or '!=' and nothing else."""
        operators = [token.text for token in inner
                     if token.text in COMPARISONS and self.is_spaced(token)]
        return operators in (["=="], ["!="]) and inner[0].text != "!"

    def change_result(self, index):
        last = index + 1
        while self.tokens[last].text != ";":
            last = self.closing.get(last, last) + 1
        inner = self.tokens[index + 1:last]
        if not inner or any(token.text in ("{", "?") for token in inner):
            return
        begin, end = inner[0].begin, inner[-1].end
        value = self.source[begin:end]
        if self.is_one_equality(inner):
            return
        if any(token.text in COMPARISONS and self.is_spaced(token) for token in inner):
            self.add(begin, end, f"!({value})")
        elif value not in ZEROS and inner[0].kind == "name":
            self.add(begin, end, "0" if self.is_old else "{}")

    def remove_statements(self):
        """Adds mutants in which a call or an assignment that is a statement is missing."""
        controls = {self.closing[index + 1] for index, token in enumerate(self.tokens)
                    if token.text in ("if", "for", "while") and index + 1 in self.closing}
        depth_of_parentheses = 0
        for index, token in enumerate(self.tokens[:-1]):
            depth_of_parentheses += (token.text == "(") - (token.text == ")")
            begins_statement = (token.text in (";", "{", "}", "else") or index in controls)
            if depth_of_parentheses == 0 and begins_statement:
                self.remove_statement(index + 1)

    def remove_statement(self, first):
        if first in self.unchanged or self.tokens[first].text in KEYWORDS:
            return
        if self.tokens[first].kind != "name" and self.tokens[first].text not in ("*", "++", "--"):
            return
        last, has_effect = first, self.tokens[first].text in ("++", "--")
        while last < len(self.tokens) and self.tokens[last].text != ";":
            token, after = self.tokens[last], next_name(self.tokens, last + 1)
            if token.text in ("{", "}", ":") or token.text == ")":
                return  # a definition, a label or the end of a block
            if (token.kind == "name" and after) or (token.text in (">", "*", "&") and after
                                                    and last > first and not self.is_spaced(token)):
                return  # a declaration
            has_effect = has_effect or token.text == "(" or token.text in ASSIGNMENTS
            last = self.closing.get(last, last) + 1
        if not has_effect or last >= len(self.tokens):
            return
        self.add(self.tokens[first].begin, self.tokens[last].end, "{}")


def mutants_of(file, source):
    """Returns the mutants of `source`, the content of `file`, in the order of the file."""
    return Maker(file, source).make()
