# For doxygen 1.9.4, which takes no notice of Markdown in the line of \exception.
/\\exception/s/`\([^`]*\)`/<code>\1<\/code>/g
