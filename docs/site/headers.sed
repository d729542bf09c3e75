# What doxygen reads of a header: without the namespace that holds everything, and without explicit instantiations.
/^namespace turgor {$/d
/^}  \/\/ namespace turgor$/d
/^extern template /,/;$/d
