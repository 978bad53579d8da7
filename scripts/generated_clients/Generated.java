package javax.annotation;

/** The annotation on every class of openapi-generator, which Java has not contained since version 11. */
public @interface Generated {
    String[] value();

    String date() default "";

    String comments() default "";
}
