"""All motions of a role as arrays, made once from clips and blend spaces."""
