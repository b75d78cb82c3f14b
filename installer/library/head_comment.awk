# Doxygen's view of a header: the comment at its head, shown as it is written (it has formulas and tables in it).
NR == 1 && /^\/\// { inside = 1; print "/** @file"; print " * @verbatim" }
inside && /^\/\// { sub(/^\/\/ ?/, ""); gsub(/\*\//, "* /"); print; next }
inside { inside = 0; print "@endverbatim */" }
{ print }
